// The tangent of bodies whose law remembers, while it flows, against the residual; and the residual
// against the energy, where no time passes.

#include "derivatives.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace thelma_test;

constexpr double branch_modulus = 0.05; // MPa

struct Case {
  int dim;
  const char* temperature;
  const char* formulation;
  int degree;
};

void PrintTo(const Case& c, std::ostream* out)
{
  *out << c.formulation << ", degree " << c.degree << ", " << c.temperature << ", " << c.dim
       << "-D";
}

void replace(std::string& text, const std::string& what, const std::string& by)
{
  const std::size_t place = text.find(what);
  ASSERT_NE(place, std::string::npos) << what;
  text.replace(place, what.size(), by);
}

/// The bilayer, whose active layer remembers.
std::string viscous_bilayer(const Case& c)
{
  std::string text = bilayer(c.temperature, c.formulation, c.degree);
  replace(text, "passive: elastomer", "passive: rubber");
  replace(text, " set Thermal expansion = 1.8e-4\n",
          " set Thermal expansion = 1.8e-4\n set Branches = Maxwell, Maxwell\n"
          " subsection Branch 1\n set Modulus = " +
              std::to_string(branch_modulus) +
              "\n set Relaxation time = 0.3\n end\n"
              " subsection Branch 2\n set Relaxation time = 0.1\n end\n");
  if (c.dim == 3)
    return text;
  replace(text, "bilayer.geo", "bilayer_plane.geo");
  replace(text, "L: 6, W: 2, n1: 4, n2: 1, n3: 4", "L: 6, n1: 4, n3: 4");
  replace(text, "x2_min: u2, x2_max: u2, ", "");
  return text;
}

class TangentWithHistory : public testing::TestWithParam<Case>
{
protected:
  /// Call @p check with the scene while it flows: bent further and charged, after two other states.
  template <typename Check>
  void while_it_flows(const Check& check) const
  {
    if (GetParam().dim == 2)
      bend<2>(check);
    else
      bend<3>(check);
  }

private:
  template <int dim, typename Check>
  void bend(const Check& check) const
  {
    TestScene<dim> scene(viscous_bilayer(GetParam()), 330.);
    double time = 0.;
    for (const double curvature : {0.05, 0.12, 0.2}) {
      std::vector<double> times;
      for (const State::Accepted& accepted : scene.state.path())
        times.push_back(accepted.load);
      time += curvature;
      scene.state.time = time;
      scene.state.rates = backward_differences(time, times, 2);
      set_bent_state(scene, curvature);
      add_noise(scene, {0.05 * curvature, 0.3, 5.}, scene.state.x);
      scene.system.converge_internal();
      if (curvature < 0.2)
        scene.state.accept(time);
    }
    check(scene);
  }
};

TEST_P(TangentWithHistory, IsTheDerivativeOfTheResidual)
{
  while_it_flows([](auto& scene) { expect_tangent_is_derivative(scene); });
}

TEST_P(TangentWithHistory, GivesNewtonSecondOrder)
{
  while_it_flows([](auto& scene) {
    ASSERT_TRUE(scene.system.residual().admissible());
    BlockVector direction = scene.layout.new_vector();
    add_noise(scene, {3e-4, 3e-2, 0.3}, direction);
    expect_second_order(scene, direction, 2e-3);
  });
}

TEST_P(TangentWithHistory, ResidualIsTheSlopeOfTheEnergyStored)
{
  while_it_flows([](auto& scene) {
    scene.state.time = scene.state.accepted_load();
    expect_residual_is_slope_of_energy(scene);
  });
}

/// Its branch is felt: were it relaxed, the forces of the nodes would be others.
TEST_P(TangentWithHistory, MemoryIsFelt)
{
  while_it_flows([](auto& scene) {
    const double some = 1e-2 * branch_modulus; // N, on 1 mm^2
    scene.system.residual();
    BlockVector change = scene.system.free_residual();
    scene.state.rates.reset();
    scene.system.residual();
    change -= scene.system.free_residual();
    EXPECT_GT(change.block(0).l2_norm(), some);
  });
}

std::vector<Case> cases()
{
  std::vector<Case> all;
  for (const int dim : {2, 3}) {
    for (const int degree : {1, 2})
      for (const char* formulation : {"standard", "selective reduced", "mean dilatation"})
        all.push_back({dim, "uniform", formulation, degree});
    for (const char* temperature : {"uniform", "transient"})
      all.push_back({dim, temperature, "enhanced strain", 1});
    all.push_back({dim, "transient", "selective reduced", 1});
    all.push_back({dim, "transient", "mean dilatation", 1});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Formulations, TangentWithHistory, testing::ValuesIn(cases()),
                         [](const auto& info) {
                           const Case& c = info.param;
                           std::string name = c.formulation;
                           name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
                           return name + std::to_string(c.degree) + "In" + std::to_string(c.dim) +
                                  "D" + (std::string(c.temperature) == "uniform" ? "" : "InTime");
                         });

} // namespace
