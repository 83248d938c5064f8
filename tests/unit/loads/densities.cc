// Loads per volume and area: how their components are read, and the work of their nodal forces
// along linear displacements and potentials against integrals of polynomials.

#include "marks.h"
#include "scene.h"

#include <thelma/base/distribution.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

using namespace thelma_test;

TEST(Densities, AreNumbersOrExpressions)
{
  const dealii::Point<3> X(2., 3., 5.);
  const Distribution<3> numbers("1 -2.5 0.003 kPa", 3, "MPa");
  EXPECT_DOUBLE_EQ(numbers(0, X, 0.), 1e-3);
  EXPECT_DOUBLE_EQ(numbers(1, X, 0.), -2.5e-3);
  EXPECT_DOUBLE_EQ(numbers(2, X, 0.), 3e-6);
  EXPECT_FALSE(numbers.changes_in_time());
  const Distribution<3> mixed("x1*x2 -2.5 sqrt(x3+t)", 3, "MPa");
  EXPECT_DOUBLE_EQ(mixed(0, X, 4.), 6.);
  EXPECT_DOUBLE_EQ(mixed(1, X, 4.), -2.5);
  EXPECT_DOUBLE_EQ(mixed(2, X, 4.), 3.);
  EXPECT_TRUE(mixed.changes_in_time());
  const Distribution<3> scaled("2e-4*x3", 1, "MPa");
  EXPECT_DOUBLE_EQ(scaled(0, X, 0.), 1e-3);
  const Distribution<3> one("2*x1 + 1e-3*pi", 1, "mW/mm^3");
  EXPECT_DOUBLE_EQ(one(0, X, 0.), 4. + 1e-3 * std::acos(-1.));
  EXPECT_FALSE(one.changes_in_time());
}

TEST(Densities, SayWhatIsWrong)
{
  const auto sentence = [](const std::string& text, const unsigned int n) {
    try {
      Distribution<3>(text, n, "MPa");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(sentence("1 2", 3).find("too few components"), std::string::npos);
  EXPECT_NE(sentence("x1 x2 x3 x1", 3).find("too many components"), std::string::npos);
  EXPECT_NE(sentence("y", 1).find("x1,x2,x3,t"), std::string::npos);
  EXPECT_THROW(Distribution<2>("x2", 1, "MPa"), InputError);
  EXPECT_NE(sentence("1 2 3 mm", 3).find("a length"), std::string::npos);
}

/// Cubes of 1 mm under everything that acts per volume and area.
std::string cube(const int degree)
{
  return "subsection Mesh\n set File = meshes/box.geo\n"
         " set Parameters = L1: 1, L2: 1, L3: 1, n1: 2, n2: 2, n3: 2\nend\n"
         "subsection Regions\n set Materials = film: elastomer\nend\n"
         "subsection Materials\n subsection elastomer\n set Density = 1000\n end\nend\n"
         "subsection Discretisation\n set Degree = " +
         std::to_string(degree) +
         "\n set Formulation = mean dilatation\nend\n"
         "subsection Supports\n set Fixed = bottom: u1 u2 u3\nend\n"
         "subsection Electrodes\n set Potential = bottom: 0\nend\n"
         "subsection Time\n set Analysis = transient\nend\n"
         "subsection Loads\n set Body force = film: x1*x2 2 x3*t\n set Gravity = 0 0 -x1\n"
         " set Traction = x1_max: x2*x3 0 t, top: 0 3*x1 0\n set Free charge = film: x1*x3\n"
         " set Surface charge = top: x2\nend\n";
}

/// The work of the @p load at twice its level and 3 s along value(component, X).
double work(TestScene<3>& scene, const std::string& load,
            const std::function<double(unsigned int, const dealii::Point<3>&)>& value)
{
  BlockVector forces = scene.layout.new_vector(), way = scene.layout.new_vector();
  scene.loads[scene.loads.index(load)].add_forces(1., {2., 3.}, scene.state, scene.state.x, forces);
  forces.compress(dealii::VectorOperation::add);
  const auto& points = scene.layout.scalar_element().get_unit_support_points();
  const auto owned = scene.layout.dof_handler().locally_owned_dofs();
  for (const Cell<3>& cell : scene.layout.cells())
    for (unsigned int a = 0; a < points.size(); ++a)
      for (unsigned int c = 0; c < 4; ++c)
        if (const auto dof = cell.dofs[a * 4 + c]; owned.is_element(dof))
          way(dof) = value(
              c, scene.layout.mapping().transform_unit_to_real_cell(cell.iterator, points[a]));
  return forces * way;
}

ON_TWO_RANKS(Densities);
TEST(Densities, DoTheWorkOfTheirIntegrals)
{
  constexpr double g = 9.80665e-6; // of 1000 kg/m^3 in N/mm^3
  const auto along = [](const unsigned int component, const unsigned int axis) {
    return [=](const unsigned int c, const dealii::Point<3>& X) {
      return c == component ? X[axis] : 0.;
    };
  };
  for (const int degree : {1, 2}) {
    TestScene<3> scene(cube(degree));
    EXPECT_NEAR(work(scene, "body force", along(0, 0)), 2. * (1. / 3.) * (1. / 2.), 1e-13);
    EXPECT_NEAR(work(scene, "body force", along(1, 2)), 2. * 2. / 2., 1e-13);
    EXPECT_NEAR(work(scene, "body force", along(2, 2)), 2. * 3. / 3., 1e-13);
    EXPECT_NEAR(work(scene, "gravity", along(2, 0)), -2. * g / 3., 1e-18);
    EXPECT_NEAR(work(scene, "traction", along(0, 1)), 2. * (1. / 3.) * (1. / 2.), 1e-13);
    EXPECT_NEAR(work(scene, "traction", along(1, 0)), 2. * 3. / 3., 1e-13);
    EXPECT_NEAR(work(scene, "traction", along(2, 2)), 2. * 3. / 2., 1e-13);
    EXPECT_NEAR(work(scene, "free charge", along(3, 2)), -2. * (1. / 2.) * (1. / 3.), 1e-13);
    EXPECT_NEAR(work(scene, "surface charge", along(3, 1)), -2. / 3., 1e-13);
  }
}

} // namespace
