#include "support.h"

/// What every material must do whatever its law: rest, free expansion, indifference to the
/// observer, symmetry; and the values of the paper's law at one point, computed independently.
namespace thelma
{
namespace
{

using namespace material_tests;

constexpr double alpha_acrylic = 1.8e-4;
constexpr const char* acrylic = "set Thermal expansion = 1.8e-4\n"
                                "set Permittivity = 5e-5, -1e-5, 2e-6";

const Tensor3<2> identity = dealii::unit_symmetric_tensor<3>();

/// Calls @p check(material, total law) for every combination of laws.
template <typename Check>
void for_each_law(const char* entries, const Check& check)
{
  for_each_material([&](auto* type, const std::string& elastic, const std::string& dielectric) {
    SCOPED_TRACE(elastic + " with " + dielectric);
    const auto material = material_with<std::remove_pointer_t<decltype(type)>>(entries);
    check(*material, total(*material));
  });
}

TEST(MaterialsProperties, RestState)
{
  for_each_law(acrylic, [](const auto& material, const auto& law) {
    const double theta_0 = material.thermal.theta_0;
    const PointState<> rest{identity, Tensor3<1>(), theta_0};
    const FirstDerivatives<> first = law.first(rest);
    EXPECT_LT(first.P.norm(), 1e-14 * material.shear_modulus(theta_0));
    EXPECT_EQ(first.D.norm(), 0.);
    EXPECT_NEAR(first.eta, 0., 1e-14 * material.thermal.c);
    EXPECT_NEAR(law.psi(rest), 0., 1e-14 * material.shear_modulus(theta_0));
  });
}

/// F = J_theta^{1/3} I, also rotated, is free of stress at every temperature. The body with
/// F_theta = J_theta I is not: by (theta/theta_0) K ln J_theta^2, which is many times mu.
TEST(MaterialsProperties, FreeThermalExpansion)
{
  for_each_law(acrylic, [](const auto& material, const auto& law) {
    RandomStates random;
    for (const double theta : {253., 293., 323., 353.}) {
      const double mu = material.shear_modulus(theta);
      const double stretch = std::exp(alpha_acrylic * (theta - material.thermal.theta_0));
      const Tensor3<2> F = stretch * random.rotation();
      // Round-off in ln J_EM is multiplied by K.
      EXPECT_LT(law.first(PointState<>{F, Tensor3<1>(), theta}).P.norm(),
                1e-14 * material.thermal.K);
      if (theta != material.thermal.theta_0) {
        const Tensor3<2> wrong = std::pow(stretch, 3) * identity;
        EXPECT_GT(law.first(PointState<>{wrong, Tensor3<1>(), theta}).P.norm(), mu);
      }
    }
  });
}

/// F -> R F: psi, D, eta and the nominal heat flux stay, P -> R P; hence P F^T is symmetric.
TEST(MaterialsProperties, Objectivity)
{
  for_each_law(acrylic, [](const auto& material, const auto& law) {
    RandomStates random;
    WorstErrors errors;
    for (unsigned int n = 0; n < 1000; ++n) {
      const PointState<> state = random.next(material);
      const Tensor3<2> R = random.rotation();
      PointState<> rotated = state;
      rotated.F = R * state.F;
      const FirstDerivatives<> before = law.first(state), after = law.first(rotated);
      const double mu = material.shear_modulus(state.theta);
      errors.add("psi", law.psi(rotated), law.psi(state), mu);
      errors.add("P", after.P, R * before.P, mu);
      errors.add("D", after.D, before.D, material.permittivity(state.theta));
      errors.add("eta", after.eta, before.eta, material.thermal.c);
      const Tensor3<2> kirchhoff = before.P * dealii::transpose(state.F);
      errors.add("P F^T", kirchhoff, dealii::transpose(kirchhoff), mu);
      errors.add("Q", material.thermal.heat_flux(Kinematics<>(rotated.F), state.E).Q,
                 material.thermal.heat_flux(Kinematics<>(state.F), state.E).Q, 0.);
    }
    errors.expect_below(1e-12);
  });
}

/// The tangent of (u, phi) is symmetric: P and D have the common potential psi.
TEST(MaterialsProperties, SymmetricTangent)
{
  for_each_law(acrylic, [](const auto& material, const auto& law) {
    RandomStates random;
    WorstErrors errors;
    for (unsigned int n = 0; n < 1000; ++n) {
      const PointState<> state = random.next(material);
      const SecondDerivatives<> second = law.second(state);
      const FirstDerivatives<Ad> first = law.first(seeded(state));
      Tensor3<4> transposed;
      Tensor3<3> dD_dF_transposed;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J)
          for (unsigned int k = 0; k < 3; ++k) {
            dD_dF_transposed[i][J][k] = d_dF(first.D[k])[i][J];
            for (unsigned int L = 0; L < 3; ++L)
              transposed[i][J][k][L] = second.dP_dF[k][L][i][J];
          }
      errors.add("dP/dF", second.dP_dF, transposed, material.shear_modulus(state.theta));
      errors.add("dP/dE = -(dD/dF)^T", second.dP_dE, -dD_dF_transposed, 0.);
      errors.add("dD/dE", second.dD_dE, dealii::transpose(second.dD_dE), 0.);
    }
    errors.expect_below(1e-12);
  });
}

/// psi = elastic + psi_v + electric - E.D + psi_t: the source of the voltage belongs to it. The
/// inner energy psi + theta eta + E.D is the sum of the stored ones.
TEST(MaterialsProperties, EnergiesAddUp)
{
  for_each_law(acrylic, [](const auto& material, const auto& law) {
    RandomStates random;
    for (unsigned int n = 0; n < 100; ++n) {
      const PointState<> state = random.next(material);
      Energies energies = material.energies(state);
      const double psi = law.psi(state);
      const Volumetric<> v = material.thermal.volumetric(Kinematics<>(state.F).J, state.theta);
      const FirstDerivatives<> first = law.first(state);
      EXPECT_NEAR(energies.elastic + v.psi + energies.electric - contract(state.E, first.D) +
                      material.thermal.psi(state.theta),
                  psi, 1e-13 * (1. + std::abs(psi)));
      const double inner = psi + state.theta * first.eta + contract(state.E, first.D);
      energies.add(1., thelma::energies(v, state.theta));
      EXPECT_NEAR(energies.elastic + energies.electric + energies.thermal +
                      material.thermal.c * (state.theta - material.thermal.theta_0),
                  inner, 1e-12 * (1. + std::abs(inner)));
      EXPECT_GE(energies.elastic, 0.);
      EXPECT_GE(energies.electric, 0.);
    }
  });
}

/// mu(theta) = (A x^2 + B x + C) / 3 MPa, x = 1000 K / theta, with A, B, C of the paper (section
/// 4), evaluated outside this program; all digits given must agree.
TEST(MaterialsProperties, ShearModulusOfThePaper)
{
  const NeoHookean law;
  const std::map<double, double> table = {
      {273., 0.084714}, {293., 0.056552}, {313., 0.038798}, {333., 0.028423}, {353., 0.023333}};
  for (const auto& [theta, mu] : table)
    EXPECT_NEAR(law.shear_modulus(theta), mu, 0.5e-6) << theta;
}

/// The material and the point of the values below: every block is different from zero.
constexpr const char* gold_material = "set Shear modulus = 1\n"
                                      "set Bulk modulus = 1000\n"
                                      "set Permittivity = 1\n"
                                      "set Thermal expansion = 2e-4\n"
                                      "set Reference temperature = 293\n"
                                      "set Heat capacity = 2";

const PointState<> gold_state{Tensor3<2>({{1.1, .2, .05}, {-.1, .95, .1}, {.02, -.05, 1.05}}),
                              Tensor3<1>({.3, -.2, .5}), 320.};

void expect_digits(const Tensor3<2>& value, const Tensor3<2>& printed)
{
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int J = 0; J < 3; ++J)
      EXPECT_NEAR(value[i][J], printed[i][J], 0.51e-10) << i << J;
}

/// The numbers come from complex-step derivatives (step 1e-30) of psi, theory.md, eq. 4, in a
/// separate program; dP/dtheta by fourth-order differences of that P. All ten decimals must agree.
TEST(MaterialsProperties, GoldValues)
{
  const auto material = material_with<PaperMaterial>(gold_material);
  const auto law = total(*material);
  const FirstDerivatives<> first = law.first(gold_state);

  EXPECT_NEAR(Kinematics<>(gold_state.F).J, 1.12345, 1e-14);
  EXPECT_NEAR(law.psi(gold_state), 2.6367708428, 0.51e-10);
  EXPECT_NEAR(first.eta, .2437748723, 0.51e-10);
  EXPECT_NEAR(first.D[0], .2797673461, 0.51e-10);
  EXPECT_NEAR(first.D[1], -.3023365526, 0.51e-10);
  EXPECT_NEAR(first.D[2], .5014645957, 0.51e-10);
  expect_digits(first.P, Tensor3<2>({{97.7615187739, 10.4430999135, -1.1721166319},
                                     {-20.6302681697, 112.1870458923, 5.6693437097},
                                     {-2.4893884127, -11.2717198995, 103.9004830036}}));
  expect_digits(law.second(gold_state).dP_dtheta,
                Tensor3<2>({{-.279373595, -.0295752617, .0040939103},
                            {.0596109044, -.3225241842, -.0163381214},
                            {.0078113358, .0322721418, -.2971400133}}));
}

} // namespace
} // namespace thelma
