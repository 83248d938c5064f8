// The transient coupled problem against manufactured solutions, and the adiabatic stretch against
// its ordinary differential equation.

#include "manufactured.h"
#include "marks.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace
{

using namespace thelma_test;

/// A cube of 1 mm with n^3 cells, everything that the laws offer switched on, and free surfaces.
std::string cube(const unsigned int n, const unsigned int degree, const std::string& formulation)
{
  const std::string count = std::to_string(n);
  return "subsection Mesh\n set File = meshes/box.geo\n set Parameters = L1: 1, L2: 1, L3: 1, "
         "n1: " +
         count + ", n2: " + count + ", n3: " + count +
         "\nend\n"
         "subsection Regions\n set Materials = film: elastomer\nend\n"
         "subsection Materials\n subsection elastomer\n set Thermal expansion = 1.8e-4\n"
         " set Bulk modulus = 1\n set Heat capacity = 0.02\n set Conductivity = 0.02\n"
         " set Permittivity = 1e-3, 0.873e-3\n end\nend\n"
         "subsection Discretisation\n set Formulation = " +
         formulation + "\n set Degree = " + std::to_string(degree) +
         "\nend\n"
         "subsection Supports\n set Fixed = x1_min: u1 u2 u3, bottom: u3\nend\n"
         "subsection Electrodes\n set Potential = bottom: 0, top: 1\nend\n"
         "subsection Temperature\n set Model = transient\n set Fixed = bottom: 300, x2_max: 300\n"
         "end\n";
}

ExactFields fields(const bool linear)
{
  return {{{{0.05, 0.04, 2., dealii::Point<3>(0.9, 0.4, -0.5), 0.3, 0.},
            {0.04, -0.05, 1.5, dealii::Point<3>(-0.3, 0.8, 0.6), 0.1, 0.},
            {-0.05, 0.03, 2.5, dealii::Point<3>(0.5, -0.6, 0.7), 0.5, 0.},
            {0.6, 0.3, 2., dealii::Point<3>(0.4, 0.5, 1.1), 0.2, 0.},
            {10., 8., 3., dealii::Point<3>(0.7, 0.9, 0.6), 0.4, 320.}}},
          linear};
}

const char* name_of(const StructuralHeat heat)
{
  return heat == StructuralHeat::power ? "H" : "entropy";
}

class InTime : public testing::TestWithParam<StructuralHeat>
{
};
SLOW(InTime);

/// Fields linear in space lie in the elements' space and are found there without error; their
/// sines in time are not.
TEST_P(InTime, DifferencesHaveTheirOrder)
{
  for (const unsigned int order : {1u, 2u}) {
    std::array<double, 3> last{};
    for (const unsigned int n : {8u, 16u, 32u}) {
      Manufactured problem(cube(2, 1, "standard"), fields(true), GetParam(), 2, true);
      problem.march(0.5, n, order);
      const std::array<double, 3> errors = problem.errors();
      std::printf("%s, order %u, %2u steps: errors of u %.2e mm, phi %.2e kV, theta %.2e K",
                  name_of(GetParam()), order, n, errors[0], errors[1], errors[2]);
      if (last[0] > 0.)
        for (unsigned int f = 0; f < 3; ++f) {
          const double found = std::log2(last[f] / errors[f]);
          std::printf(f == 0 ? ", orders %.2f" : " %.2f", found);
          if (n == 32) {
            EXPECT_NEAR(found, order, 0.15);
          }
        }
      std::printf("\n");
      last = errors;
    }
  }
}

/// Sines in space; the time steps of BDF2 shrink so fast that the error in time follows.
TEST_P(InTime, ElementsHaveTheirOrder)
{
  for (const unsigned int degree : {1u, 2u}) {
    std::array<double, 3> last{};
    unsigned int last_n = 0;
    for (const unsigned int n : {2u, 3u, 4u}) {
      const unsigned int steps = degree == 1 ? 4 * n : 2 * n * n;
      Manufactured problem(cube(n, degree, "mean dilatation"), fields(false), GetParam(),
                           degree + 3, false);
      problem.march(0.1, steps, 2);
      const std::array<double, 3> errors = problem.errors();
      std::printf("%s, Q%u, %u^3 cells, %2u steps: errors of u %.2e mm, phi %.2e kV, theta %.2e K",
                  name_of(GetParam()), degree, n, steps, errors[0], errors[1], errors[2]);
      if (last_n > 0)
        for (unsigned int f = 0; f < 3; ++f) {
          const double found = std::log(last[f] / errors[f]) / std::log(double(n) / last_n);
          std::printf(f == 0 ? ", orders %.2f" : " %.2f", found);
          if (n == 4) {
            EXPECT_GT(found, degree + 1 - 0.2);
          }
        }
      std::printf("\n");
      last = errors;
      last_n = n;
    }
  }
}

/// A block without heat flow that is stretched to twice its length in 1 s at constant volume:
/// homogeneous, F = diag(l, l^-1/2, l^-1/2). mu/theta_0 is so large that it warms by degrees.
class AdiabaticStretch
{
public:
  static Tensor3<2> F(const double t)
  {
    const double l = 1. + t, s = 1. / std::sqrt(l);
    return Tensor3<2>({{l, 0., 0.}, {0., s, 0.}, {0., 0., s}});
  }

  static PointRates rates(const double t)
  {
    const double l = 1. + t, s_dot = -0.5 * std::pow(l, -1.5);
    return {Tensor3<2>({{1., 0., 0.}, {0., s_dot, 0.}, {0., 0., s_dot}}), {}};
  }

  AdiabaticStretch() : scene(text) {}

  /// Temperature and entropy (MPa/K) at 1 s after @p n steps.
  std::pair<double, double> march(const unsigned int n, const unsigned int order,
                                  const StructuralHeat heat)
  {
    const Newton newton;
    for (unsigned int i = 1; i <= n; ++i) {
      const double t = double(i) / n;
      std::vector<double> times;
      for (const auto& accepted : scene.state.path())
        times.push_back(accepted.load);
      scene.state.rates = backward_differences(t, times, order);
      scene.state.rates->heat = heat;
      const auto& points = scene.layout.scalar_element().get_unit_support_points();
      for (const Cell<3>& cell : scene.layout.cells())
        for (unsigned int a = 0; a < points.size(); ++a) {
          const auto X =
              scene.layout.mapping().transform_unit_to_real_cell(cell.iterator, points[a]);
          for (unsigned int c = 0; c < 3; ++c)
            scene.state.x(cell.dofs[a * cell.n_components + c]) = (F(t)[c][c] - 1.) * X[c];
        }
      EXPECT_TRUE(newton.solve(scene.system).converged);
      scene.state.accept(t);
    }
    const double theta = scene.state.x.block(1)(0);
    return {theta, entropy(1., theta)};
  }

  double entropy(const double t, const double theta) const
  {
    FirstDerivatives<> d{};
    WholeEnergy().add(material(), {F(t), {}, theta}, Kinematics<>(F(t)), 0, d);
    return d.eta;
  }

  /// c theta_dot = H by the classical Runge-Kutta method, in steps so small that its error is
  /// round-off.
  double exact() const
  {
    const auto theta_dot = [&](const double t, const double theta) {
      EntropyRate rate;
      WholeEnergy().add_entropy_rate(material(), {F(t), {}, theta}, rates(t), rate);
      return -theta * rate.h / material().thermal.c;
    };
    constexpr unsigned int n = 1000;
    constexpr double h = 1. / n;
    double theta = 293.;
    for (unsigned int i = 0; i < n; ++i) {
      const double t = i * h, k1 = theta_dot(t, theta),
                   k2 = theta_dot(t + h / 2., theta + h / 2. * k1),
                   k3 = theta_dot(t + h / 2., theta + h / 2. * k2),
                   k4 = theta_dot(t + h, theta + h * k3);
      theta += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
    }
    return theta;
  }

private:
  const Material& material() const { return *scene.layout.cells().front().material; }

  static constexpr const char* text =
      "subsection Mesh\n set File = meshes/box.geo\n"
      " set Parameters = L1: 1, L2: 1, L3: 1, n1: 1, n2: 1, n3: 1\nend\n"
      "subsection Regions\n set Materials = film: elastomer\n set Passive = film\nend\n"
      "subsection Materials\n subsection elastomer\n set Shear modulus = 5\n end\nend\n"
      "subsection Discretisation\n set Formulation = mean dilatation\nend\n"
      "subsection Supports\n set Fixed = x1_min: u1, x1_max: u1, x2_min: u2, x2_max: u2, "
      "bottom: u3, top: u3\nend\n"
      "subsection Temperature\n set Model = transient\nend\n";
  TestScene<3> scene;
};

/// With a shear modulus that does not depend on temperature c is the exact capacity.
TEST(Adiabatic, StretchReachesTheTemperatureOfItsEquation)
{
  const double exact = AdiabaticStretch().exact(), start = AdiabaticStretch().entropy(0., 293.);
  std::printf("stretched to 2: %.6f K by the ordinary differential equation\n", exact);
  EXPECT_GT(exact - 293., 1.);
  for (const unsigned int order : {1u, 2u}) {
    double last_error = 0., last_change = 0.;
    for (const unsigned int n : {20u, 40u, 80u}) {
      const auto [theta, entropy] = AdiabaticStretch().march(n, order, StructuralHeat::power);
      const double error = std::abs(theta - exact), change = std::abs(entropy - start);
      std::printf("H, order %u, %u steps: error %.2e K, entropy changes by %.2e MPa/K", order, n,
                  error, change);
      if (last_error > 0.) {
        std::printf(", orders %.2f %.2f", std::log2(last_error / error),
                    std::log2(last_change / change));
        EXPECT_NEAR(std::log2(last_error / error), order, 0.15);
        EXPECT_NEAR(std::log2(last_change / change), order, 0.15);
      }
      std::printf("\n");
      last_error = error;
      last_change = change;
    }
  }
}

/// The entropy form keeps the entropy in every single step.
TEST(Adiabatic, EntropyFormKeepsTheEntropy)
{
  const double exact = AdiabaticStretch().exact(), start = AdiabaticStretch().entropy(0., 293.);
  for (const unsigned int order : {1u, 2u}) {
    const auto [theta, entropy] = AdiabaticStretch().march(20, order, StructuralHeat::entropy);
    EXPECT_NEAR(theta, exact, 1e-7);
    EXPECT_NEAR(entropy, start, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Manufactured, InTime,
                         testing::Values(StructuralHeat::power, StructuralHeat::entropy),
                         [](const auto& info) { return name_of(info.param); });

} // namespace
