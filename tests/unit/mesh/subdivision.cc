// Cells between arcs, halved: every vertex lies where the arcs say.

#include <thelma/mesh/subdivision.h>
#include <thelma/mesh/whole_mesh.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace thelma;

constexpr double degree = 3.14159265358979323846 / 180.;

/// A cell from radius 1 to 2, 60 degrees wide and 1 long, with its inner face, an edge and a
/// corner.
template <typename Place>
CoarseMesh wedge(const Place& place)
{
  CoarseMesh mesh;
  // gmsh counts the corners of the bottom around it, then those of the top.
  for (const double z : {0., 1.})
    for (const auto& [r, angle] :
         std::vector<std::pair<double, double>>{{1., 0.}, {2., 0.}, {2., 60.}, {1., 60.}})
      mesh.vertices.push_back(place(r, angle * degree, z));
  mesh.groups = {{"wall", 3, {{0, 1, 2, 3, 4, 5, 6, 7}}},
                 {"inner", 2, {{0, 3, 7, 4}}},
                 {"edge", 1, {{1, 2}}},
                 {"corner", 0, {{6}}}};
  return mesh;
}

/// Whether @p x is a multiple of @p step.
bool is_multiple(const double x, const double step)
{
  return std::abs(x / step - std::round(x / step)) < 1e-13;
}

TEST(Subdivision, KeepsArcsAroundEachAxis)
{
  for (int k = 0; k < 3; ++k) {
    const auto place = [k](const double r, const double angle, const double z) {
      std::array<double, 3> x;
      x[k] = z;
      x[(k + 1) % 3] = r * std::cos(angle);
      x[(k + 2) % 3] = r * std::sin(angle);
      return x;
    };
    const std::string around = "x" + std::to_string(k + 1);
    const CoarseMesh fine = subdivided(subdivided(wedge(place), around), around);
    EXPECT_EQ(fine.vertices.size(), 125U);
    for (const auto& x : fine.vertices) {
      EXPECT_TRUE(is_multiple(std::hypot(x[(k + 1) % 3], x[(k + 2) % 3]), 0.25));
      EXPECT_TRUE(is_multiple(std::atan2(x[(k + 2) % 3], x[(k + 1) % 3]), 15. * degree));
      EXPECT_TRUE(is_multiple(x[k], 0.25));
    }
    const WholeMesh<3> whole(fine); // which refuses cells that do not fit together
    EXPECT_EQ(whole.cells.size(), 64U);
    const MeshTable table = whole.table();
    EXPECT_EQ(table.surfaces.at("inner").size(), 16U);
    EXPECT_EQ(table.surfaces.at("edge").size(), 4U);
    EXPECT_EQ(table.surfaces.at("corner").size(), 1U);
  }
}

TEST(Subdivision, KeepsSpheres)
{
  const auto place = [](const double r, const double angle, const double z) {
    const double height = z * 45. * degree;
    return std::array<double, 3>{{r * std::cos(height) * std::cos(angle),
                                  r * std::cos(height) * std::sin(angle), r * std::sin(height)}};
  };
  const CoarseMesh fine = subdivided(wedge(place), "the origin");
  EXPECT_EQ(fine.vertices.size(), 27U);
  for (const auto& x : fine.vertices)
    EXPECT_TRUE(is_multiple(std::hypot(x[0], x[1], x[2]), 0.5));
  EXPECT_EQ(WholeMesh<3>(fine).cells.size(), 8U);
}

} // namespace
