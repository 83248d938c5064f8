// A follower pressure: its tangent against its forces, its forces against the enclosed volume whose
// gradient they are, and the volumes of a sphere and a tube in closed form.

#include "derivatives.h"
#include "marks.h"

#include <thelma/fields/deformed_surface.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace thelma_test;

constexpr double pi = 3.14159265358979323846;

std::string balloon(const int degree)
{
  return "subsection Mesh\n set File = meshes/balloon.geo\n set Curved = around the origin\n"
         " set Parameters = R: 3, H: 1, n: 2, nr: 1\nend\n"
         "subsection Regions\n set Materials = wall: elastomer\nend\n"
         "subsection Discretisation\n set Degree = " +
         std::to_string(degree) +
         "\n set Formulation = mean dilatation\nend\n"
         "subsection Supports\n set Fixed = x1_min: u1, x2_min: u2, x3_min: u3\nend\n"
         "subsection Electrodes\n set Potential = outer: 0, inner: 1\nend\n";
}

std::string tube()
{
  return "subsection Mesh\n set File = meshes/tube_quarter_plane.geo\n set Curved = around x2\n"
         " set Parameters = n1: 2, n3: 3\nend\n"
         "subsection Regions\n set Materials = wall: elastomer\nend\n"
         "subsection Discretisation\n set Degree = 2\n set Formulation = mean dilatation\nend\n"
         "subsection Supports\n set Fixed = x1_axis: u3, x3_axis: u1\nend\n"
         "subsection Electrodes\n set Potential = outer: 0, inner: 1\nend\n";
}

/// Half a spherical shell, as a body of revolution.
std::string shell()
{
  std::string text = tube();
  text.replace(text.find("around x2"), 9, "around the origin");
  text.replace(text.find(", x3_axis: u1"), 13, "");
  return "set Geometry = axisymmetric\n" + text;
}

/// A scene under pressure in a random state.
template <int dim>
struct Pressed {
  explicit Pressed(const std::string& text)
      : scene(text + "subsection Loads\n set Pressure = inner: 0.5, outer: 0.2\nend\n")
  {
    set_level(1.3);
    add_noise(scene, {0.03, 1., 0.}, scene.state.x);
    scene.system.converge_internal();
  }

  void set_level(const double level)
  {
    std::vector<double> levels = scene.loads.levels();
    levels[scene.loads.index("pressure")] = level;
    scene.loads.set_levels(levels);
  }

  BlockVector forces() const
  {
    BlockVector sum = scene.layout.new_vector();
    scene.loads.add_forces(
        1., scene.state, scene.state.x, [](Field) { return true; }, sum);
    sum.compress(dealii::VectorOperation::add);
    return sum;
  }

  /// Pressures times the volumes that they enclose: minus their energy.
  double work()
  {
    double sum = 0.;
    for (const auto& [name, value] : {std::pair{"inner", 0.5}, std::pair{"outer", 0.2}}) {
      DeformedSurface<dim> surface;
      surface.setup(scene.mesh, scene.layout, name, "");
      sum -= 1.3 * value * surface.own_volume(scene.layout, scene.state.x);
    }
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  TestScene<dim> scene;
};

template <int dim>
void check_forces(const std::string& text)
{
  Pressed<dim> pressed(text);
  TestScene<dim>& scene = pressed.scene;
  BlockVector direction = scene.layout.new_vector();
  add_noise(scene, {1e-2, 0., 0.}, direction);
  double slope = 0.;
  differentiate(
      scene, direction, [&]() { return pressed.work(); },
      [&](const double weight, const double work) { slope += weight * work; });
  const BlockVector forces = pressed.forces();
  direction.zero_out_ghost_values();
  EXPECT_NEAR(forces * direction, slope, 1e-10 * std::abs(slope));
}

template <int dim>
void check_tangent(const std::string& text)
{
  Pressed<dim> pressed(text);
  TestScene<dim>& scene = pressed.scene;
  BlockVector direction = scene.layout.new_vector(), slope = direction, product = direction;
  add_noise(scene, {1e-3, 0., 0.}, direction);
  ASSERT_TRUE(scene.system.residual().admissible());
  scene.system.linear.assemble();
  scene.system.linear.matrix().vmult(product, direction);
  differentiate(
      scene, direction,
      [&]() {
        scene.system.converge_internal();
        EXPECT_TRUE(scene.system.residual().admissible());
        return scene.system.free_residual();
      },
      [&](const double weight, const BlockVector& residual) { slope.add(weight, residual); });
  for (unsigned int b = 0; b < slope.n_blocks(); ++b) {
    auto difference = product.block(b);
    difference -= slope.block(b);
    EXPECT_LE(difference.l2_norm(), 1e-6 * slope.block(b).l2_norm()) << "block " << b;
  }
}

/// Of the pressure alone, so that the stiffness of the rubber hides nothing.
template <int dim>
void check_own_tangent(const std::string& text)
{
  Pressed<dim> pressed(text);
  TestScene<dim>& scene = pressed.scene;
  BlockVector direction = scene.layout.new_vector(), slope = direction, product = direction;
  add_noise(scene, {1e-2, 0., 0.}, direction);
  TangentMatrix<dim> tangent;
  tangent.setup(scene.layout, scene.conditions);
  tangent.clear();
  scene.loads.add_tangent(
      scene.state, [](Field) { return true; }, tangent);
  tangent.finish();
  tangent.matrix().vmult(product, direction);
  differentiate(
      scene, direction, [&]() { return pressed.forces(); },
      [&](const double weight, const BlockVector& forces) { slope.add(-weight, forces); });
  scene.conditions.constraints().set_zero(slope);
  product -= slope;
  EXPECT_LT(product.l2_norm(), 1e-9 * slope.l2_norm());
}

TEST(FollowerPressure, ForcesAreTheGradientOfTheEnclosedVolume)
{
  check_forces<3>(balloon(1));
  check_forces<3>(balloon(2));
  check_forces<2>(tube());
  check_forces<2>(shell());
}

ON_TWO_RANKS(FollowerPressureTangent);

TEST(FollowerPressureTangent, IsTheDerivativeOfTheResidual)
{
  check_own_tangent<3>(balloon(1));
  check_own_tangent<3>(balloon(2));
  check_own_tangent<2>(tube());
  check_own_tangent<2>(shell());
  check_tangent<3>(balloon(1));
  check_tangent<3>(balloon(2));
  check_tangent<2>(tube());
  check_tangent<2>(shell());
}

/// The error after one step from a distance d to a random state, held by the forces it needs, falls
/// as d^2.
TEST(FollowerPressureTangent, GivesNewtonSecondOrder)
{
  Pressed<3> pressed(balloon(2));
  pressed.set_level(0.1); // about the shear modulus: more, and directions lose their stiffness
  TestScene<3>& scene = pressed.scene;
  ASSERT_TRUE(scene.system.residual().admissible());
  BlockVector direction = scene.layout.new_vector();
  add_noise(scene, {3e-4, 3e-2, 0.}, direction);
  expect_second_order(scene, direction, 0.02);
}

/// The error of quadratic arcs falls with the fourth power of their length.
TEST(DeformedSurface, EnclosesASphereAndATube)
{
  const auto sphere = [](const int n) {
    std::string text = balloon(2);
    text.replace(text.find("n: 2"), 4, "n: " + std::to_string(n));
    TestScene<3> scene(text);
    DeformedSurface<3> surface;
    surface.setup(scene.mesh, scene.layout, "inner", "");
    const double own = surface.own_volume(scene.layout, scene.state.x);
    return -dealii::Utilities::MPI::sum(own, MPI_COMM_WORLD) / (pi / 6. * 27.) - 1.;
  };
  const double coarse = std::abs(sphere(2)), fine = std::abs(sphere(4));
  EXPECT_LT(coarse, 1e-3);
  EXPECT_GT(std::log2(coarse / fine), 3.8) << coarse << " " << fine;

  for (const auto& [text, exact] : {std::pair{tube(), pi}, std::pair{shell(), 16. / 3. * pi}}) {
    TestScene<2> scene(text);
    DeformedSurface<2> surface;
    surface.setup(scene.mesh, scene.layout, "outer", "");
    const double own = surface.own_volume(scene.layout, scene.state.x);
    EXPECT_NEAR(dealii::Utilities::MPI::sum(own, MPI_COMM_WORLD) / exact, 1., 1e-3);
  }
}

TEST(FollowerPressure, RefusesFreeEdges)
{
  std::string text = balloon(1);
  text.replace(text.find(", x3_min: u3"), 12, ", outer_end: u3");
  try {
    const Pressed<3> pressed(text);
    FAIL() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'inner'"), std::string::npos) << error.what();
  }
}

} // namespace
