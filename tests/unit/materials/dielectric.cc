#include "support.h"

/// The dielectric laws against their energies written once more, in their limits, and in lanes.
/// (oracle.cc has their derivatives.)
namespace thelma
{
namespace
{

using namespace material_tests;

using Ideal = ComposedMaterial<NeoHookean, IdealDielectric>;
using Electrostrictive = ComposedMaterial<NeoHookean, ElectrostrictiveDielectric>;
using Saturating = ComposedMaterial<NeoHookean, SaturatingDielectric>;

constexpr double eps = 3.98e-5; // N/kV^2

/// The law alone.
template <class Law>
void set(Law& law, const std::string& entries)
{
  dealii::ParameterHandler prm;
  law.declare(prm);
  prm.parse_input_from_string(entries);
}

double true_field(const PointState<>& state)
{
  return (dealii::transpose(dealii::invert(state.F)) * state.E).norm();
}

/// Through C instead of the code's F^{-T}.
TEST(MaterialsDielectric, ElectrostrictiveEnergy)
{
  ElectrostrictiveDielectric law;
  set(law, "set Electrostriction = 0.3, 0.1");
  RandomStates random;
  for (unsigned int n = 0; n < 100; ++n) {
    const PointState<> state = random.next(PaperMaterial());
    const Tensor3<2> C = dealii::transpose(state.F) * state.F;
    const double k = 1. - 0.3 + 0.1 * (dealii::trace(C) - 3.);
    const double exact =
        -eps / 2. * dealii::determinant(state.F) *
        (k * (state.E * (dealii::invert(C) * state.E)) + 0.3 * state.E.norm_square());
    EXPECT_NEAR(law.psi(state, Kinematics<>(state.F)) / exact, 1., 1e-13);
  }
}

/// Along the principal axes it is Zhao and Suo's permittivity, of squared stretches.
TEST(MaterialsDielectric, ElectrostrictionAlongTheAxes)
{
  const auto material = material_with<Electrostrictive>("set Electrostriction = 0.2, -0.02");
  const std::array<double, 3> stretches{{1.7, 1.2, 0.5}};
  PointState<> state{Tensor3<2>(), Tensor3<1>({0., 0., 30.}), 293.};
  for (unsigned int i = 0; i < 3; ++i)
    state.F[i][i] = stretches[i];
  const double trace = 1.7 * 1.7 + 1.2 * 1.2 + 0.5 * 0.5,
               permittivity = eps * (1. + 0.2 * (0.5 * 0.5 - 1.) - 0.02 * (trace - 3.)),
               area = 1.7 * 1.2, field = 30. / 0.5;
  EXPECT_NEAR(material->first_derivatives(state).D[2] / (area * permittivity * field), 1., 1e-14);
}

TEST(MaterialsDielectric, NoStateWithoutPositivePermittivity)
{
  const auto loses = material_with<Electrostrictive>("set Electrostriction = 0, -0.01"),
             along = material_with<Electrostrictive>("set Electrostriction = -0.2, 0");
  const auto stress = [](const Electrostrictive& material, const double stretch) {
    PointState<> state{Tensor3<2>(), Tensor3<1>({0., 0., 1.}), 293.};
    state.F[0][0] = state.F[1][1] = stretch;
    state.F[2][2] = 1. / (stretch * stretch);
    return material.first_derivatives(state).P[0][0];
  };
  EXPECT_TRUE(std::isfinite(stress(*loses, 7.17))); // 2 lambda^2 + lambda^-4 = 103 at 7.176
  EXPECT_TRUE(std::isnan(stress(*loses, 7.18)));
  EXPECT_TRUE(std::isfinite(stress(*along, 2.449))); // lambda^2 = 6 at 2.4495
  EXPECT_TRUE(std::isnan(stress(*along, 2.45)));
}

/// The energy as it is printed, in more digits.
TEST(MaterialsDielectric, SaturatingEnergy)
{
  constexpr long double vacuum = 8.8541878e-6L, P_s = 2e-3L, chi = 3.98e-5L - vacuum;
  SaturatingDielectric law;
  set(law, "set Saturation polarisation = 2e-3");
  RandomStates random;
  for (unsigned int n = 0; n < 300; ++n) {
    PointState<> state = random.next(PaperMaterial());
    state.E *= random.uniform(0.01, 10.);
    const long double g = true_field(state), x = 3.L * chi * g / P_s;
    const long double aligned =
        x > 0.01L ? std::log(std::sinh(x) / x) : x * x / 6.L * (1.L - x * x / 30.L);
    const double exact = -dealii::determinant(state.F) *
                         double(vacuum / 2.L * g * g + P_s * P_s / (3.L * chi) * aligned);
    const Kinematics<> kin(state.F);
    EXPECT_NEAR(law.psi(state, kin) / exact, 1., 1e-13);
    FirstDerivatives<> first{};
    law.add_first(state, kin, first);
    const Tensor3<1> d = state.F * first.D / dealii::determinant(state.F);
    const double polarised = (1. / std::tanh(double(x)) - 1. / double(x)) * double(P_s);
    EXPECT_NEAR((d.norm() - double(vacuum * g)) / polarised, 1., 1e-10);
  }
}

/// Without electrostriction and without a limit both are the ideal one; so is a weak field.
TEST(MaterialsDielectric, TendToTheIdeal)
{
  const auto ideal = material_with<Ideal>("");
  const auto unstrained = material_with<Electrostrictive>("set Electrostriction = 0, 0");
  const auto unlimited = material_with<Saturating>("set Saturation polarisation = 1e6"),
             limited = material_with<Saturating>("");
  RandomStates random;
  WorstErrors errors;
  for (unsigned int n = 0; n < 100; ++n) {
    PointState<> state = random.next(*ideal);
    const auto compare = [&](const std::string& block, const auto& material) {
      const FirstDerivatives<> ours = material.first_derivatives(state),
                               exact = ideal->first_derivatives(state);
      errors.add(block + " P", ours.P, exact.P, ideal->shear_modulus(state.theta));
      errors.add(block + " D", ours.D, exact.D, 0.);
    };
    compare("unstrained", *unstrained);
    compare("unlimited", *unlimited);
    state.E *= 1e-7;
    compare("weak field", *limited);
    state.E = Tensor3<1>();
    EXPECT_EQ(limited->first_derivatives(state).D.norm(), 0.);
  }
  errors.expect_below(1e-13);
}

/// The functions of the square, on both sides of where the series end, in more digits.
TEST(MaterialsDielectric, LangevinOfTheSquare)
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double worst = 0.;
  const auto differs = [&](const double ours, const long double exact) {
    worst = std::max(worst, double(std::abs(ours / exact - 1.L)) / epsilon);
  };
  for (double z = 0.05; z < 1e8; z *= 1.1) {
    const LangevinOfSquare<double> f(z);
    const long double x = std::sqrt((long double)z), L = 1.L / std::tanh(x) - 1.L / x,
                      slope = 1.L - L * L - 2.L * L / x, ratio = 3.L * L / x,
                      aligned = x + std::log((1.L - std::exp(-2.L * x)) / (2.L * x)),
                      mean = 6.L * aligned / z;
    differs(f.ratio, ratio);
    differs(f.mean, mean);
    differs(f.slope, 1.5L * (slope - L / x) / z);
    differs(f.mean_slope, (ratio - mean) / z);
  }
  std::printf("largest error of the functions of the square: %.1f eps\n", worst);
  EXPECT_LT(worst, 300.);
  const LangevinOfSquare<double> f(0.);
  EXPECT_EQ(f.ratio, 1.);
  EXPECT_EQ(f.mean, 1.);
  EXPECT_DOUBLE_EQ(f.slope, -1. / 15.);
  EXPECT_DOUBLE_EQ(f.mean_slope, -1. / 30.);
}

TEST(MaterialsDielectric, LanesAreWhatTheyAreAlone)
{
  for_each_material([](auto* type, const std::string&, const std::string& name) {
    SCOPED_TRACE(name);
    const auto material = material_with<std::remove_pointer_t<decltype(type)>>(
        "set Permittivity = 240: 4.1e-5, 300: 4e-5, 350: 3.5e-5, 410: 4.4e-5\n"
        "set Saturation polarisation = 2e-3");
    RandomStates random;
    std::array<PointState<>, Lanes::n> states;
    PointState<Lanes> all;
    for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
      states[lane] = random.next(*material);
      states[lane].E *= lane; // one without field
      for (unsigned int i = 0; i < 3; ++i) {
        for (unsigned int J = 0; J < 3; ++J)
          all.F[i][J].set(lane, states[lane].F[i][J]);
        all.E[i].set(lane, states[lane].E[i]);
      }
      all.theta.set(lane, states[lane].theta);
    }
    const SecondDerivatives<Lanes> together = material->second_derivatives(all);
    for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
      const SecondDerivatives<> alone = material->second_derivatives(states[lane]);
      const double size = alone.dP_dF.norm(), eta = std::abs(alone.deta_dtheta);
      EXPECT_NEAR(together.deta_dtheta[lane], alone.deta_dtheta, 1e-13 * eta);
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J)
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int L = 0; L < 3; ++L)
              EXPECT_NEAR(together.dP_dF[i][J][k][L][lane], alone.dP_dF[i][J][k][L], 1e-13 * size);
    }
  });
}

} // namespace
} // namespace thelma
