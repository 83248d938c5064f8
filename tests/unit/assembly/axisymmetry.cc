// Bodies of revolution: the tangent against differences of the residual, the residual against the
// slope of the energy, the order of Newton's method, and what is integrated over the whole body
// against its closed form.

#include "derivatives.h"
#include "marks.h"

#include <thelma/elements/integrate.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace thelma_test;

constexpr double pi = 3.14159265358979323846;

struct Case {
  const char* temperature;
  const char* formulation;
  int degree;
};

void PrintTo(const Case& c, std::ostream* out)
{
  *out << c.formulation << ", degree " << c.degree << ", " << c.temperature;
}

/// Two layers, the inner one of which touches the axis; 1 mm thick, 2 mm high.
std::string layers(const Case& c)
{
  std::string text = bilayer(c.temperature, c.formulation, c.degree);
  for (const auto& [from, to] : {std::pair{"bilayer.geo", "bilayer_plane.geo"},
                                 {"L: 6, W: 2, n1: 4, n2: 1, n3: 4", "L: 2, n1: 4, n3: 3"},
                                 {"x3_min: u3, x2_min: u2, x2_max: u2, pin: u1", "x3_min: u3"},
                                 {"interface: 0, outer: 1", "x3_min: 0, x3_max: 1"},
                                 {"outer: 353, back: 293", "x3_min: 353, x3_max: 293"}})
    if (const std::size_t place = text.find(from); place != std::string::npos)
      text.replace(place, std::string(from).size(), to);
  return "set Geometry = axisymmetric\n" + text;
}

class Axisymmetry : public testing::TestWithParam<Case>
{
protected:
  Axisymmetry() : scene(layers(GetParam()), 330.)
  {
    const bool is_transient = std::string(GetParam().temperature) == "transient";
    double time = 0.;
    for (const double size : {0.04, 0.07}) { // cells find their enhanced strains step by step
      set_bulged_state(size);
      disturb(size);
      if (is_transient)
        scene.state.accept(time += size);
    }
    set_bulged_state(0.1);
    if (is_transient) {
      scene.state.rates = backward_differences(time + 0.1, {time - 0.07, time}, 2);
      scene.state.rates->heat = StructuralHeat::power;
    }
    disturb(0.1);
  }

  /// The body bulges in the middle and carries a field.
  void set_bulged_state(const double size)
  {
    const auto& points = scene.layout.scalar_element().get_unit_support_points();
    for (const Cell<2>& cell : scene.layout.cells())
      for (unsigned int a = 0; a < points.size(); ++a) {
        const dealii::Point<2> X =
            dealii::MappingQ1<2>().transform_unit_to_real_cell(cell.iterator, points[a]);
        scene.state.x(cell.dofs[a * cell.n_components]) = size * X[0] * std::sin(1.5 * X[1]);
        scene.state.x(cell.dofs[a * cell.n_components + 1]) = -size * X[1] * (1. + X[0] * X[0]);
        if (cell.has_potential)
          scene.state.x(cell.dofs[a * cell.n_components + 2]) = 8. * X[1];
      }
    scene.state.x.zero_out_ghost_values();
    scene.state.x.update_ghost_values();
  }

  void disturb(const double size)
  {
    add_noise(scene, {0.02 * size, 0.3, 5.}, scene.state.x);
    scene.system.converge_internal();
  }

  TestScene<2> scene;
};
ON_TWO_RANKS(Axisymmetry);

TEST_P(Axisymmetry, TangentIsTheDerivativeOfTheResidual)
{
  expect_tangent_is_derivative(scene);
}

TEST_P(Axisymmetry, NewtonHasSecondOrder)
{
  BlockVector direction = scene.layout.new_vector();
  add_noise(scene, {3e-4, 3e-2, 0.3}, direction);
  expect_second_order(scene, direction, 2e-2);
}

TEST_P(Axisymmetry, ResidualIsTheSlopeOfTheEnergy)
{
  if (!scene.state.rates)
    expect_residual_is_slope_of_energy(scene);
}

INSTANTIATE_TEST_SUITE_P(
    Formulations, Axisymmetry,
    testing::Values(Case{"uniform", "standard", 1}, Case{"uniform", "standard", 2},
                    Case{"uniform", "selective reduced", 1},
                    Case{"uniform", "selective reduced", 2}, Case{"uniform", "mean dilatation", 1},
                    Case{"uniform", "mean dilatation", 2}, Case{"uniform", "enhanced strain", 1},
                    Case{"steady", "mean dilatation", 2}, Case{"steady", "enhanced strain", 1},
                    Case{"transient", "standard", 1}, Case{"transient", "selective reduced", 1},
                    Case{"transient", "mean dilatation", 1},
                    Case{"transient", "mean dilatation", 2},
                    Case{"transient", "enhanced strain", 1}),
    [](const auto& info) {
      std::string name = info.param.formulation;
      name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
      return name + std::to_string(info.param.degree) + info.param.temperature;
    });

TEST(BodyOfRevolution, HasItsVolumeAndHeatCapacity)
{
  for (const int degree : {1, 2}) {
    TestScene<2> scene(layers({"transient", "mean dilatation", degree}));
    const Integration<2> rule(scene.layout, degree + 1);
    double volume = 0.;
    for (std::size_t cell = 0; cell < scene.layout.cells().size(); ++cell)
      for (unsigned int q = 0; q < rule.basis().n_points; ++q)
        volume += rule.of_cell(cell)[q].JxW;
    EXPECT_NEAR(dealii::Utilities::MPI::sum(volume, MPI_COMM_WORLD), 2. * pi, 1e-12);
    const double c = scene.layout.cells().front().material->thermal.c;
    scene.state.x.block(scene.layout.block(Field::temperature)) = 294.;
    const double heat = scene.storage.stored(scene.state, 293.).thermal;
    EXPECT_NEAR(dealii::Utilities::MPI::sum(heat, MPI_COMM_WORLD), 2. * pi * c, 1e-11 * c);
  }
}

} // namespace
