// The assembled tangent against the residual it claims to be the derivative of, and the order of
// Newton's method that follows from it. The truth is the residual itself.

#include "derivatives.h"
#include "marks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace thelma_test;

struct Case {
  const char* temperature;
  const char* formulation;
  int degree;
  StructuralHeat heat = StructuralHeat::none;
};

std::string heat_name(const Case& c)
{
  return c.heat == StructuralHeat::power     ? "Power"
         : c.heat == StructuralHeat::entropy ? "Entropy"
                                             : "";
}

void PrintTo(const Case& c, std::ostream* out)
{
  *out << c.formulation << ", degree " << c.degree << ", " << c.temperature << " " << heat_name(c);
}

class Tangent : public testing::TestWithParam<Case>
{
};
SLOW(Tangent);
ON_TWO_RANKS(Tangent);

/// With displacements disturbed by @p noise (mm); in transient cases with two accepted states
/// behind it, at uneven times.
void set_state(const Case& c, const double noise, TestScene<3>& scene)
{
  double time = 0.;
  if (std::string(c.temperature) == "transient")
    for (const double curvature : {0.05, 0.12}) {
      set_bent_state(scene, curvature);
      add_noise(scene, {noise * curvature, 0.3, 5.}, scene.state.x);
      scene.system.converge_internal();
      time += curvature;
      scene.state.accept(time);
    }
  set_bent_state(scene, 0.2);
  add_noise(scene, {noise, 0.3, 5.}, scene.state.x);
  if (time > 0.) {
    scene.state.rates = backward_differences(time + 0.2, {time - 0.12, time}, 2);
    scene.state.rates->heat = c.heat;
  }
  scene.system.converge_internal();
}

TEST_P(Tangent, IsTheDerivativeOfTheResidual)
{
  const Case c = GetParam();
  TestScene<3> scene(bilayer(c.temperature, c.formulation, c.degree), 330.);
  set_state(c, 0.01, scene);
  expect_tangent_is_derivative(scene);
}

/// The exact solution is a bent, charged, heated state with random fields, held by the dead nodal
/// forces it needs. The error after one step from a distance d falls as d^2.
TEST_P(Tangent, GivesNewtonSecondOrder)
{
  const Case c = GetParam();
  TestScene<3> scene(bilayer(c.temperature, c.formulation, c.degree), 330.);
  set_state(c, 0.001, scene); // with more, directions lose their stiffness
  ASSERT_TRUE(scene.system.residual().admissible());
  BlockVector direction = scene.layout.new_vector();
  add_noise(scene, {3e-4, 3e-2, 0.3}, direction);
  expect_second_order(scene, direction, 2e-3);
}

/// The residual is the slope of what the formulation says it stores, elastic minus electric
/// energy; the energy is the truth. Heat conduction has none, so the temperature stays.
TEST_P(Tangent, ResidualIsTheSlopeOfTheEnergy)
{
  const Case c = GetParam();
  TestScene<3> scene(bilayer(c.temperature, c.formulation, c.degree), 330.);
  set_bent_state(scene, 0.2);
  add_noise(scene, {0.01, 0.3, 5.}, scene.state.x);
  expect_residual_is_slope_of_energy(scene);
}

/// Along a whole curve, towards the pull-in at 25.91 kV: the last residuals of each step obey
/// r_(n+1) <= C r_n^2 down to round-off, with one C for all.
TEST(NewtonAlongACurve, ResidualsFallQuadraticallyInEveryStep)
{
  TestScene<3> scene("subsection Mesh\n set File = meshes/box.geo\nend\n"
                     "subsection Regions\n set Materials = film: elastomer\nend\n"
                     "subsection Discretisation\n set Formulation = mean dilatation\nend\n"
                     "subsection Supports\n set Fixed = x1_min: u1, x2_min: u2, bottom: u3\nend\n"
                     "subsection Electrodes\n set Potential = bottom: 0, top: 1\nend\n");
  constexpr double C = 2000.;
  Newton newton;
  dealii::ParameterHandler prm;
  newton.declare(prm);
  prm.parse_input_from_string("subsection Newton\n set Reuse tangent = false\nend\n");
  for (const double voltage : {2., 5., 9., 12., 15., 18., 20., 22., 23., 24., 25., 25.5, 25.8}) {
    scene.apply_voltage(voltage);
    const std::vector<double> r = newton.solve(scene.system).residuals;
    const std::size_t n = r.size();
    ASSERT_GE(n, 3u);
    ASSERT_LT(r[n - 1], 1e-10) << voltage << " kV";
    for (const std::size_t k : {n - 2, n - 1})
      EXPECT_LT(r[k], std::max(C * r[k - 1] * r[k - 1], 1e-12)) << voltage << " kV";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Formulations, Tangent,
    testing::Values(Case{"uniform", "selective reduced", 1}, Case{"uniform", "standard", 1},
                    Case{"uniform", "selective reduced", 2}, Case{"uniform", "mean dilatation", 1},
                    Case{"uniform", "mean dilatation", 2}, Case{"steady", "mean dilatation", 2},
                    Case{"steady", "selective reduced", 1}, Case{"steady", "standard", 2},
                    Case{"transient", "mean dilatation", 1},
                    Case{"transient", "mean dilatation", 1, StructuralHeat::power},
                    Case{"transient", "mean dilatation", 1, StructuralHeat::entropy},
                    Case{"transient", "mean dilatation", 2, StructuralHeat::power},
                    Case{"transient", "mean dilatation", 2, StructuralHeat::entropy},
                    Case{"transient", "selective reduced", 1, StructuralHeat::power},
                    Case{"transient", "selective reduced", 1, StructuralHeat::entropy},
                    Case{"transient", "standard", 1, StructuralHeat::power},
                    Case{"transient", "standard", 1, StructuralHeat::entropy},
                    Case{"uniform", "enhanced strain", 1}, Case{"steady", "enhanced strain", 1},
                    Case{"transient", "enhanced strain", 1, StructuralHeat::power},
                    Case{"transient", "enhanced strain", 1, StructuralHeat::entropy}),
    [](const auto& info) {
      std::string name = info.param.formulation;
      name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
      const std::string model = info.param.temperature;
      return name + std::to_string(info.param.degree) +
             (model == "uniform"  ? ""
              : model == "steady" ? "WithTheta"
                                  : "InTime") +
             heat_name(info.param);
    });

} // namespace
