#include "support.h"

#include <thelma/materials/principal_frame.h>

/// Ogden's law where principal stretches are equal, or nearly: against powers of C by matrix square
/// roots, which have no principal directions, and Sacado on these. (oracle.cc has random states.)
namespace thelma
{
namespace
{

using namespace material_tests;

using OgdenMaterial = ComposedMaterial<Ogden, IdealDielectric>;

/// Powers q = alpha/2 - 1 of C that are multiples of 1/8.
struct Term {
  double alpha, mu;
};
const std::vector<Term> eighths{{1.25, 0.63}, {5., 0.0012}, {-2., -0.01}, {14., 1e-4}};
constexpr const char* entries = "set Ogden terms = 1.25: 0.63, 5: 0.0012, -2: -0.01, 14: 1e-4";

const Tensor3<2> identity = dealii::unit_symmetric_tensor<3>();

/// Square root of a symmetric positive matrix (Denman and Beavers).
template <typename Number>
Tensor3<2, Number> root(Tensor3<2, Number> Y)
{
  Tensor3<2, Number> Z(identity);
  for (unsigned int step = 0; step < 12; ++step) {
    const Tensor3<2, Number> old = Y;
    Y = 0.5 * (Y + Tensor3<2, Number>(dealii::invert(Z)));
    Z = 0.5 * (Z + Tensor3<2, Number>(dealii::invert(old)));
  }
  return Y;
}

/// P of these terms without volumetric energy.
template <typename Number>
Tensor3<2, Number> stress(const Tensor3<2, Number>& F)
{
  const Tensor3<2, Number> C = dealii::transpose(F) * F, eighth = root(root(root(C)));
  Tensor3<2, Number> P;
  for (const auto& [alpha, mu] : eighths) {
    const int n = std::lround(8. * (alpha / 2. - 1.));
    const Tensor3<2, Number> factor = n < 0 ? Tensor3<2, Number>(dealii::invert(eighth)) : eighth;
    Tensor3<2, Number> power(identity);
    for (int k = 0; k < std::abs(n); ++k)
      power = power * factor;
    P += mu * (F * power - Kinematics<Number>(F).G);
  }
  return P;
}

/// F with principal stretches a relative @p gap apart: two of them, or all three.
Tensor3<2> nearly_equal(RandomStates& random, const double gap, const unsigned int n_equal)
{
  Tensor3<2> stretch;
  const double middle = random.uniform(0.7, 1.5);
  for (unsigned int i = 0; i < 3; ++i)
    stretch[i][i] = i < n_equal ? middle * (1. + gap * random.uniform(-1., 1.)) : 0.8 * middle;
  return random.rotation() * stretch * random.rotation();
}

constexpr double gaps[] = {0., 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 0.5};

/// Calls @p check(state) at many such states.
template <typename Check>
void for_each_gap(const Check& check)
{
  RandomStates random;
  for (const double gap : gaps)
    for (unsigned int n_equal : {2, 3})
      for (unsigned int n = 0; n < 20; ++n)
        check(PointState<>{nearly_equal(random, gap, n_equal), Tensor3<1>(), 293.});
}

TEST(MaterialsOgden, EqualAndNearlyEqualStretches)
{
  const auto material = material_with<OgdenMaterial>(entries);
  const double mu = material->shear_modulus(293.);
  WorstErrors errors;
  for_each_gap([&](const PointState<>& state) {
    const Tensor3<2, Ad> exact = stress(seeded(state).F);
    Tensor3<2> P;
    Tensor3<4> dP_dF;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J) {
        P[i][J] = exact[i][J].val();
        dP_dF[i][J] = d_dF(exact[i][J]);
      }
    errors.add("P", material->first_derivatives(state).P, P, mu);
    errors.add("dW/dF", derivatives_of_energy(material->psi(seeded(state))).P, P, mu);
    errors.add("dP/dF", material->second_derivatives(state).dP_dF, dP_dF, mu);
    const FirstDerivatives<Ad> first = material->first_derivatives(seeded(state));
    Tensor3<4> of_first;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        of_first[i][J] = d_dF(first.P[i][J]);
    errors.add("dP/dF of P", of_first, dP_dF, mu);
  });
  errors.expect_below(1e-12);
}

/// Third derivatives, which the heat of a moving point needs, against differences.
TEST(MaterialsOgden, ThirdDerivatives)
{
  const auto material = material_with<OgdenMaterial>(entries);
  const double mu = material->shear_modulus(293.), step = 1e-5;
  RandomStates random;
  WorstErrors errors;
  for_each_gap([&](const PointState<>& state) {
    PointState<> above = state, below = state;
    const PointRates rates{random.deformation(), Tensor3<1>()};
    above.F += step * rates.F;
    below.F -= step * rates.F;
    const Tensor3<4> difference =
        (material->second_derivatives(above).dP_dF - material->second_derivatives(below).dP_dF) /
        (2. * step);
    const SecondDerivatives<Directional> moving = material->second_derivatives(along(state, rates));
    Tensor3<4> ours;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int L = 0; L < 3; ++L)
            ours[i][J][k][L] = moving.dP_dF[i][J][k][L].dx(0);
    errors.add("d2P/dF2", ours, difference, mu);
  });
  errors.expect_below(2e-7);
}

/// The second divided difference of exp in more digits where its places are apart, and by
/// e^m/2 (1 + ...) where they meet.
TEST(MaterialsOgden, SecondDifferenceOfExp)
{
  RandomStates random;
  for (double spread = 1e-9; spread < 20.; spread *= 1.5) {
    const double x = random.uniform(-2., 2.), y = x + spread * random.uniform(0.3, 0.6),
                 z = x + spread;
    const long double middle = (x + y + z) / 3., u = x - middle, v = y - middle, w = z - middle;
    const auto over = [](const long double a, const long double b) {
      return std::expm1(b - a) * std::exp(a) / (b - a);
    };
    const long double exact =
        spread < 1e-4 ? 0.5L + (u * u + v * v + w * w) / 48.L : (over(v, w) - over(u, v)) / (w - u);
    EXPECT_NEAR(exp_second_difference(y, z, x) / double(std::exp(middle) * exact), 1., 1e-13)
        << spread;
  }
}

/// Points in one register, equal stretches beside others, are what they are alone.
TEST(MaterialsOgden, LanesAreWhatTheyAreAlone)
{
  const auto material = material_with<OgdenMaterial>(entries);
  const double mu = material->shear_modulus(293.);
  RandomStates random;
  WorstErrors errors;
  for (unsigned int n = 0; n < 100; ++n) {
    std::vector<PointState<>> states;
    PointState<Lanes> together;
    for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
      states.push_back(random.next(*material));
      if (lane % 2 == 0)
        states.back().F = nearly_equal(random, gaps[n % 10], 2 + n % 2);
      for (unsigned int i = 0; i < 3; ++i) {
        for (unsigned int J = 0; J < 3; ++J)
          together.F[i][J].set(lane, states[lane].F[i][J]);
        together.E[i].set(lane, states[lane].E[i]);
      }
      together.theta.set(lane, states[lane].theta);
    }
    const FirstDerivatives<Lanes> first = material->first_derivatives(together);
    const SecondDerivatives<Lanes> second = material->second_derivatives(together);
    for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
      Tensor3<2> P;
      Tensor3<4> dP_dF;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J) {
          P[i][J] = first.P[i][J][lane];
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int L = 0; L < 3; ++L)
              dP_dF[i][J][k][L] = second.dP_dF[i][J][k][L][lane];
        }
      errors.add("P", P, material->first_derivatives(states[lane]).P, mu);
      errors.add("dP/dF", dP_dF, material->second_derivatives(states[lane]).dP_dF, mu);
    }
  }
  errors.expect_below(1e-13);
}

/// As exact as F has them, however far apart the stretches are.
TEST(MaterialsOgden, PrincipalStretchesAreExact)
{
  RandomStates random;
  for (unsigned int n = 0; n < 1000; ++n) {
    Tensor3<2> stretch;
    Tensor3<1> exact, found;
    for (unsigned int i = 0; i < 3; ++i)
      exact[i] = stretch[i][i] = std::exp(random.uniform(-5., 5.));
    const PrincipalFrame<double> at(random.rotation() * stretch);
    for (unsigned int i = 0; i < 3; ++i)
      found[i] = std::exp(at.log_stretch[i]);
    std::sort(&exact[0], &exact[0] + 3);
    std::sort(&found[0], &found[0] + 3);
    for (unsigned int i = 0; i < 3; ++i)
      EXPECT_NEAR(found[i] / exact[i], 1., 1e-14);
    EXPECT_NEAR((dealii::transpose(at.V) * at.V - identity).norm(), 0., 1e-14);
  }
}

/// Terms are as they are given, or scaled to a shear modulus that depends on temperature.
TEST(MaterialsOgden, ScalesToTheShearModulus)
{
  const auto given = material_with<OgdenMaterial>(entries);
  EXPECT_NEAR(given->shear_modulus(350.), (1.25 * 0.63 + 5. * 0.0012 + 2. * 0.01 + 14. * 1e-4) / 2.,
              1e-15);
  const auto scaled =
      material_with<OgdenMaterial>(std::string(entries) + "\nset Shear modulus = 0.05, 0.02\n"
                                                          "set Thermal expansion = 1.8e-4");
  RandomStates random;
  WorstErrors errors;
  for (unsigned int n = 0; n < 100; ++n) {
    PointState<> state = random.next(*scaled);
    const double mu = scaled->shear_modulus(state.theta);
    EXPECT_NEAR(mu, 0.05 + 0.02 * 1000. / state.theta, 1e-15);
    const FirstDerivatives<> ours = scaled->first_derivatives(state),
                             exact = derivatives_of_energy(scaled->psi(seeded(state)));
    errors.add("P", ours.P, exact.P, mu);
    errors.add("eta", ours.eta, exact.eta, scaled->thermal.c);
    const FirstDerivatives<Ad> first = scaled->first_derivatives(seeded(state));
    const SecondDerivatives<> second = scaled->second_derivatives(state);
    errors.add("deta/dF", -second.dP_dtheta, d_dF(first.eta), mu / 293.);
    errors.add("deta/dtheta", second.deta_dtheta, d_dtheta(first.eta), mu / (293. * 293.));
    state.theta = scaled->thermal.theta_0;
    errors.add("energy", scaled->energies(state).elastic / scaled->shear_modulus(state.theta),
               given->energies(state).elastic / given->shear_modulus(state.theta), 0.);
  }
  errors.expect_below(1e-12);
}

/// alpha = 2 is neo-Hookean, and a zero exponent no energy.
TEST(MaterialsOgden, IsNeoHookeanForSquares)
{
  const auto ogden = material_with<OgdenMaterial>("set Ogden terms = 2: 0.3, 0: 5");
  const auto neo_hookean = material_with<PaperMaterial>("set Shear modulus = 0.3");
  RandomStates random;
  WorstErrors errors;
  for (unsigned int n = 0; n < 100; ++n) {
    const PointState<> state = random.next(*neo_hookean);
    errors.add("energy", ogden->energies(state).elastic, neo_hookean->energies(state).elastic, 0.3);
    errors.add("P", ogden->first_derivatives(state).P, neo_hookean->first_derivatives(state).P, 0.);
    errors.add("dP/dF", ogden->second_derivatives(state).dP_dF,
               neo_hookean->second_derivatives(state).dP_dF, 0.);
  }
  errors.expect_below(1e-13);
}

} // namespace
} // namespace thelma
