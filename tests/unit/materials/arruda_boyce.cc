#include "support.h"

/// Arruda and Boyce's law: the inverse Langevin function to rounding, chains at all lengths, and
/// their limits. (oracle.cc has the derivatives with the default locking stretch.)
namespace thelma
{
namespace
{

using namespace material_tests;

using Chains = ComposedMaterial<ArrudaBoyce, IdealDielectric>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Langevin's function by its series around 0 or by its definition, in more digits.
long double langevin(const long double x)
{
  if (x > 0.3L)
    return 1.L / std::tanh(x) - 1.L / x;
  const long double s = x * x;
  long double f = 25.L;
  for (int k = 23; k > 1; k -= 2)
    f = k + s / f;
  return x / f;
}

/// Compared by what is given: r = L(x) fixes x to eps r/(x L'(x)), which grows as 1/(1 - r).
TEST(MaterialsArrudaBoyce, InverseLangevinIsExact)
{
  double worst = 0.;
  for (double x = 1e-12; x < 1e6; x *= 1.01) {
    const double r = langevin(x), inverse = inverse_langevin(r);
    const long double given = langevin(inverse);
    const double slope = 1. / double(x * x) - (x < 300. ? 1. / std::pow(std::sinh(x), 2) : 0.),
                 condition = x < 1e-3 ? 1. : std::max(1., r / (x * slope));
    worst = std::max(worst, std::abs(inverse / x - 1.) / (epsilon * condition));
    EXPECT_NEAR(double(given / r), 1., 4. * epsilon) << x;
  }
  std::printf("largest error of L^-1: %.1f eps (times its condition)\n", worst);
  EXPECT_LT(worst, 8.);
}

TEST(MaterialsArrudaBoyce, LanesAreWhatTheyAreAlone)
{
  for (double x = 1e-9; x < 1e5; x *= 1.1) {
    Lanes r;
    for (unsigned int lane = 0; lane < Lanes::n; ++lane)
      r.set(lane, langevin(x * (1. + lane)));
    const Lanes together = inverse_langevin(r);
    const Langevin<Lanes> all(together);
    for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
      const Langevin<double> alone(together[lane]);
      EXPECT_NEAR(together[lane] / inverse_langevin(r[lane]), 1., 8. * epsilon / (1. - r[lane]));
      EXPECT_NEAR(all.value[lane] / alone.value, 1., 4. * epsilon);
      EXPECT_NEAR(all.slope[lane] / alone.slope, 1., 8. * epsilon);
      EXPECT_NEAR(all.log_shc[lane] / alone.log_shc, 1., 8. * epsilon);
    }
  }
}

/// Near locking and with chains almost without end, against Sacado.
TEST(MaterialsArrudaBoyce, DerivativesAtAllLengths)
{
  for (const char* stretch : {"1.01", "1.5", "2.3", "30", "1e4"}) {
    const auto material = material_with<Chains>(std::string("set Locking stretch = ") + stretch);
    const double limit = std::atof(stretch);
    RandomStates random;
    WorstErrors errors;
    unsigned int n_states = 0;
    for (unsigned int n = 0; n < 1000; ++n) {
      const PointState<> state = random.next(*material);
      const double r = state.F.norm() / (std::sqrt(3.) * limit);
      const FirstDerivatives<> ours = material->first_derivatives(state);
      if (r > 0.99) {
        EXPECT_TRUE(r < 1. || std::isnan(ours.P[0][0]));
        continue;
      }
      ++n_states;
      const FirstDerivatives<> exact = derivatives_of_energy(material->psi(seeded(state)));
      const double mu = material->shear_modulus(state.theta);
      errors.add("P", ours.P, exact.P, mu);
      errors.add("eta", ours.eta, exact.eta, material->thermal.c);
      const SecondDerivatives<> second = material->second_derivatives(state);
      const FirstDerivatives<Ad> first = material->first_derivatives(seeded(state));
      Tensor3<4> dP_dF;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J)
          dP_dF[i][J] = d_dF(first.P[i][J]);
      errors.add("dP/dF", second.dP_dF, dP_dF, mu);
    }
    EXPECT_GT(n_states, 100u) << stretch;
    errors.expect_below(1e-12);
  }
}

/// No stress where the chains are longer than they can be.
TEST(MaterialsArrudaBoyce, ChainsLock)
{
  const auto material = material_with<Chains>("set Locking stretch = 2");
  PointState<> state;
  state.theta = 293.;
  for (const double stretch : {1.99, 2., 2.01}) {
    state.F = stretch * Tensor3<2>(dealii::unit_symmetric_tensor<3>());
    EXPECT_EQ(std::isnan(material->first_derivatives(state).P[0][0]), stretch >= 2.) << stretch;
  }
}

/// W of the first five terms of the series in 1/lambda_L^2 (Arruda and Boyce 1993), which
/// lambda_L = 100 needs no more of; and the initial shear modulus from that of lambda_L = 2.
TEST(MaterialsArrudaBoyce, SeriesAndInitialModulus)
{
  const auto long_chains =
      material_with<Chains>("set Shear modulus = 1\nset Locking stretch = 100");
  PointState<> state;
  state.F = Tensor3<2>({{1.9, .4, -.1}, {-.2, .8, .2}, {.1, .15, .9}});
  state.theta = long_chains->thermal.theta_0;
  const double I_1 = contract(state.F, state.F), n = 1e4;
  const double c[] = {1. / 2., 1. / 20., 11. / 1050., 19. / 7000., 519. / 673750.};
  double series = 0., modulus = 0.;
  for (int i = 0; i < 5; ++i) {
    series += c[i] / std::pow(n, i) * (std::pow(I_1, i + 1) - std::pow(3., i + 1));
    modulus += 2. * c[i] * (i + 1) * std::pow(3. / n, i);
  }
  series -= modulus * std::log(dealii::determinant(state.F));
  EXPECT_NEAR(long_chains->energies(state).elastic, series, 1e-11);
  EXPECT_NEAR(long_chains->shear_modulus(293.), modulus, 1e-14);

  // L^-1(1/2) = 1.796755984...: not G, but 1.19783732 of it.
  const auto short_chains = material_with<Chains>("set Shear modulus = 1\nset Locking stretch = 2");
  const double mu = short_chains->shear_modulus(293.), shear = 1e-6;
  state.F = Tensor3<2>({{1., shear, 0.}, {0., 1., 0.}, {0., 0., 1.}});
  EXPECT_NEAR(short_chains->first_derivatives(state).P[0][1] / shear, mu, 1e-9);
  EXPECT_NEAR(mu, 1.197837323149142, 1e-14);
}

} // namespace
} // namespace thelma
