// What is said of a mesh as a whole: which bodies meet, whether its edges are arcs.

#include <thelma/base/error.h>
#include <thelma/mesh/whole_mesh.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace thelma;

/// Two blocks one upon the other, not welded: between them a plane that rises by @p slope per mm of
/// x1, and a @p gap. The upper block is the wider one, so that no nodes coincide.
template <int dim>
WholeMesh<dim> two_blocks(const double slope, const double gap)
{
  CoarseMesh coarse;
  for (const double wider : {0., 0.5}) {
    PhysicalGroup group{wider > 0. ? "upper" : "lower", dim, {{}}};
    const auto add = [&](const double x, const double y, const bool meets) {
      const double z = !meets ? (wider > 0. ? 4. : 0.) : 1. + slope * x + (wider > 0. ? gap : 0.);
      group.elements[0].push_back(coarse.vertices.size());
      coarse.vertices.push_back({{x, dim == 3 ? y : 0., z}});
    };
    for (const double y : {-wider, 1. + wider}) {
      if (dim == 2 && y > 0.)
        break;
      add(-wider, y, false);
      add(1. + wider, y, false);
      add(1. + wider, y, true);
      add(-wider, y, true);
    }
    coarse.groups.push_back(group);
  }
  return WholeMesh<dim>(coarse);
}

template <int dim>
void expect_contacts_only_without_a_gap()
{
  for (const double slope : {0., 0.3, 1.}) {
    const std::vector<std::string> said = contacts(two_blocks<dim>(slope, 0.));
    ASSERT_EQ(said.size(), 1u) << slope;
    EXPECT_NE(said[0].find("'lower' and 'upper'"), std::string::npos) << said[0];
    EXPECT_TRUE(contacts(two_blocks<dim>(slope, 0.01)).empty()) << slope;
  }
}

TEST(Contacts, AreFacesThatMeetHoweverSlantedInThePlane)
{
  expect_contacts_only_without_a_gap<2>();
}

TEST(Contacts, AreFacesThatMeetHoweverSlantedInSpace)
{
  expect_contacts_only_without_a_gap<3>();
}

/// A cell between two radii and the angles 0 and 0.4 in the plane, one of its corners off by @p
/// off.
WholeMesh<2> sector(const double inner, const double outer, const double off)
{
  CoarseMesh coarse;
  for (const auto& [r, angle] :
       {std::pair{inner, 0.}, {outer, 0.}, {outer + off, 0.4}, {inner, 0.4}})
    coarse.vertices.push_back({{r * std::cos(angle), 0., r * std::sin(angle)}});
  coarse.groups.push_back({"ring", 2, {{0, 1, 2, 3}}});
  return WholeMesh<2>(coarse);
}

TEST(Arcs, AreEdgesWithOneRadiusOrOneDirection)
{
  EXPECT_NO_THROW(require_arcs(sector(1., 2., 0.), "around x2"));
  EXPECT_THROW(require_arcs(sector(1., 2., 0.01), "around x2"), InputError);
  EXPECT_THROW(require_arcs(sector(1e-9, 2., 0.), "around x2"), InputError); // no hole
}

} // namespace
