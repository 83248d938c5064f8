#include "support.h"

#include <vector>

/// Every hand-written derivative of the point physics against Sacado: first derivatives against
/// the energy, tangents against the hand-written P, D, eta. A law added to
/// materials/material_list.h is tested without another line here.
namespace thelma
{
namespace
{

using namespace material_tests;

constexpr unsigned int n_states = 1000;

/// Round-off of both routes is some 1e-14 of a block; a wrong term is of its order.
constexpr double tolerance = 1e-12;

/// With and without thermal expansion, a permittivity that depends on temperature, tables, and
/// strong effects of deformation and field on the permittivity. Without heat capacity, entropy
/// shows its elastic and electric parts, which c would hide a thousandfold.
struct Parameters {
  const char* entries;
  unsigned int n_branches = 0;
};

constexpr Parameters parameter_sets[] = {
    {"set Thermal expansion = 0"},
    {"set Thermal expansion = 1.8e-4"},
    {"set Thermal expansion = 0\n"
     "set Heat capacity = 0\n"
     "set Permittivity = 5e-5, -1e-5, 2e-6"},
    {"set Thermal expansion = 1.8e-4\n"
     "set Heat capacity = 0\n"
     "set Permittivity = 5e-5, -1e-5, 2e-6"},
    {"set Thermal expansion = 1.8e-4\n"
     "subsection Branch 1\n set Modulus = 0.4, -0.1, 0.01\n set Relaxation time = 2\n"
     " set Shift = WLF\nend\n"
     "subsection Branch 2\n set Relaxation time = 0.5, 1\n set Shift = Arrhenius\nend",
     2},
    {"set Thermal expansion = 1.8e-4\n"
     "set Heat capacity = 0\n"
     "set Shear modulus = 240: 0.15, 270: 0.09, 293: 0.0566, 353: 0.02, 410: 0.025\n"
     "set Permittivity = 240: 4.1e-5, 300: 4e-5, 350: 3.5e-5, 410: 4.4e-5\n"
     "set Electrostriction = 0.4, 0.05\n"
     "set Saturation polarisation = 1e-3\n"
     "set Energy = (a + b/theta)*(I1 - 3 - 2*log(J)) + sqrt(I1*I2 + 1)/(10 + I1) + "
     "c*((I1 - 3)^2 + I2/J^(2/3))*exp(-theta/300), a: 0.01, b: 5, c: 2e-3\n"
     "subsection Branch 1\n set Modulus = 240: 0.4, 320: 0.1, 410: 0.01\n"
     " set Relaxation time = 240: 30, 290: 10, 410: 0.3\nend",
     1},
};

/// The sizes of the terms each block is the sum of.
struct Scales {
  Scales(const Material& material, const double theta)
      : stress(material.shear_modulus(theta)), permittivity(material.permittivity(theta)),
        displacement(std::sqrt(permittivity * stress)), theta_0(material.thermal.theta_0),
        entropy(material.thermal.c + stress / theta_0)
  {
  }

  double stress, permittivity, displacement, theta_0, entropy;
};

template <class Law>
void compare_first(const Law& law, const PointState<>& state, const Scales& scale,
                   WorstErrors& errors)
{
  const FirstDerivatives<> ours = law.first(state);
  const FirstDerivatives<> exact = derivatives_of_energy(law.psi(seeded(state)));
  errors.add("P", ours.P, exact.P, scale.stress);
  errors.add("D", ours.D, exact.D, scale.displacement);
  std::vector<double> now(law.material.n_history()), still(law.material.n_step());
  law.material.update_history(state, now.data());
  law.material.begin_step({}, now.data(), nullptr, still.data());
  PointState<> arrived = state; // where the potential of the step is the energy
  if (!now.empty())
    arrived.history = {still.data()};
  const FirstDerivatives<> stored = derivatives_of_energy(law.psi(seeded(arrived)));
  errors.add("P at the end of the step", stored.P, ours.P, scale.stress);
  errors.add("eta", ours.eta, stored.eta, scale.entropy);
}

/// The six blocks of SecondDerivatives and the three that follow from them.
template <class Law>
void compare_second(const Law& law, const PointState<>& state, const Scales& scale,
                    WorstErrors& errors)
{
  const SecondDerivatives<> ours = law.second(state);
  const FirstDerivatives<Ad> first = law.first(seeded(state));

  Tensor3<4> dP_dF;
  Tensor3<3> dP_dE, dD_dF, minus_dP_dE_transposed;
  Tensor3<2> dP_dtheta, dD_dE;
  Tensor3<1> dD_dtheta;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int J = 0; J < 3; ++J) {
      dP_dF[i][J] = d_dF(first.P[i][J]);
      dP_dE[i][J] = d_dE(first.P[i][J]);
      dP_dtheta[i][J] = d_dtheta(first.P[i][J]);
      for (unsigned int L = 0; L < 3; ++L)
        minus_dP_dE_transposed[L][i][J] = -ours.dP_dE[i][J][L];
    }
    dD_dF[i] = d_dF(first.D[i]);
    dD_dE[i] = d_dE(first.D[i]);
    dD_dtheta[i] = d_dtheta(first.D[i]);
  }

  errors.add("dP/dF", ours.dP_dF, dP_dF, scale.stress);
  errors.add("dP/dE", ours.dP_dE, dP_dE, scale.displacement);
  errors.add("dP/dtheta", ours.dP_dtheta, dP_dtheta, scale.stress / scale.theta_0);
  errors.add("dD/dF", minus_dP_dE_transposed, dD_dF, scale.displacement);
  errors.add("dD/dE", ours.dD_dE, dD_dE, scale.permittivity);
  errors.add("dD/dtheta", ours.dD_dtheta, dD_dtheta, scale.displacement / scale.theta_0);
  if (!state.history.is_relaxed())
    return; // the derivatives of entropy leave the flow out
  errors.add("deta/dF", -ours.dP_dtheta, d_dF(first.eta), scale.stress / scale.theta_0);
  errors.add("deta/dE", ours.dD_dtheta, d_dE(first.eta), scale.displacement / scale.theta_0);
  errors.add("deta/dtheta", ours.deta_dtheta, d_dtheta(first.eta), scale.entropy / scale.theta_0);
}

/// Call @p compare(material, states, errors) at many random states of every material and parameter
/// set.
template <typename Compare>
void for_each_state(const Compare& compare)
{
  for_each_material([&](auto* type, const std::string& elastic, const std::string& dielectric) {
    for (const auto& [entries, n_branches] : parameter_sets) {
      SCOPED_TRACE(testing::Message() << elastic << " with " << dielectric << ", " << entries);
      const auto material =
          material_with<std::remove_pointer_t<decltype(type)>>(entries, n_branches);
      RandomStates states;
      WorstErrors errors;
      for (unsigned int n = 0; n < n_states; ++n)
        compare(*material, states, errors);
      errors.expect_below(tolerance);
    }
  });
}

/// @p part makes of a material the law to test: Total or WithoutVolumetric.
template <typename Part>
void compare_every_material(const Part& part)
{
  for_each_state([&](const auto& material, RandomStates& states, WorstErrors& errors) {
    const PointState<> state = states.next(material);
    const Scales scale(material, state.theta);
    compare_first(part(material), state, scale, errors);
    compare_second(part(material), state, scale, errors);
  });
}

TEST(MaterialsOracle, LawsWithoutVolumetricEnergy)
{
  compare_every_material([](const auto& material) { return without_volumetric(material); });
}

TEST(MaterialsOracle, LawsWithVolumetricEnergy)
{
  compare_every_material([](const auto& material) { return total(material); });
}

/// The rate of entropy at random rates: its derivatives by Sacado on the hand-written second
/// derivatives, with deta/dF = -dP/dtheta and deta/dE = dD/dtheta.
template <class Law>
void compare_entropy_rate(const Law& law, const EntropyRate& ours, const PointState<>& state,
                          const PointRates& rates, const Scales& scale, WorstErrors& errors)
{
  const SecondDerivatives<Ad> d = law.second(seeded(state));
  Ad h = 0.;
  Tensor3<2> deta_dF;
  Tensor3<1> deta_dE;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int J = 0; J < 3; ++J) {
      h -= d.dP_dtheta[i][J] * rates.F[i][J];
      deta_dF[i][J] = -d.dP_dtheta[i][J].val();
    }
    h += d.dD_dtheta[i] * rates.E[i];
    deta_dE[i] = d.dD_dtheta[i].val();
  }
  const double unit = scale.stress / scale.theta_0;
  errors.add("h", ours.h, h.val(), unit);
  errors.add("dh/dF", ours.d_dF, d_dF(h), unit);
  errors.add("dh/dE", ours.d_dE, d_dE(h), scale.displacement / scale.theta_0);
  errors.add("dh/dtheta", ours.d_dtheta, d_dtheta(h), unit / scale.theta_0);
  errors.add("dh/dF_dot", ours.d_dFdot, deta_dF, unit);
  errors.add("dh/dE_dot", ours.d_dEdot, deta_dE, scale.displacement / scale.theta_0);
}

TEST(MaterialsOracle, EntropyRate)
{
  for_each_state([](const auto& material, RandomStates& states, WorstErrors& errors) {
    PointState<> state = states.next(material);
    state.history = {}; // what flows is counted otherwise (FlowHeat)
    const Scales scale(material, state.theta);
    const PointRates rates{states.deformation(), states.next(material).E};
    EntropyRate part;
    material.add_entropy_rate(state, rates, part);
    compare_entropy_rate(without_volumetric(material), part, state, rates, scale, errors);
    add_volumetric_entropy_rate(material.thermal, state, rates, part);
    compare_entropy_rate(total(material), part, state, rates, scale, errors);
  });
}

/// psi_v of theory.md, eq. 13, written once more.
template <typename Number>
Number volumetric_energy(const Thermal& thermal, const Number& J, const Number& theta)
{
  const Number J_theta = exp(3. * thermal.alpha * (theta - thermal.theta_0));
  const Number ln_J_EM = log(J / J_theta);
  return theta / thermal.theta_0 * thermal.K / 2. * ln_J_EM * ln_J_EM;
}

TEST(MaterialsOracle, VolumetricEnergy)
{
  using Ad2 = Sacado::Fad::SFad<double, 2>; // J, theta
  for (const double alpha : {0., 1.8e-4}) {
    Thermal thermal;
    thermal.alpha = alpha;
    const double K = thermal.K, theta_0 = thermal.theta_0;
    RandomStates random;
    WorstErrors errors;
    for (unsigned int n = 0; n < n_states; ++n) {
      const double J = random.uniform(0.3, 3.), theta = random.uniform(250., 400.);
      const Volumetric<> v = thermal.volumetric(J, theta);
      const Ad2 J_ad(2, 0, J), theta_ad(2, 1, theta);
      const Ad2 psi = volumetric_energy(thermal, J_ad, theta_ad);
      const Volumetric<Ad2> v_ad = thermal.volumetric(J_ad, theta_ad);
      errors.add("psi", v.psi, psi.val(), K);
      errors.add("p", v.p, psi.dx(0), K);
      errors.add("eta", v.eta, -psi.dx(1), K / theta_0);
      errors.add("dp/dJ", v.dp_dJ, v_ad.p.dx(0), K);
      errors.add("dp/dtheta", v.dp_dtheta, v_ad.p.dx(1), K / theta_0);
      errors.add("deta/dJ", -v.dp_dtheta, v_ad.eta.dx(0), K / theta_0);
      errors.add("deta/dtheta", v.deta_dtheta, v_ad.eta.dx(1), K / (theta_0 * theta_0));
    }
    errors.expect_below(tolerance);
  }
}

/// Fourier's law as theory.md, eq. 22, has it, through C instead of the code's F^{-T}.
template <typename Number>
Tensor3<1, Number> heat_flux(const double k, const Tensor3<2, Number>& F,
                             const Tensor3<1, Number>& grad_theta)
{
  const Tensor3<2, Number> C = dealii::transpose(F) * F;
  const Number k_J = k * dealii::determinant(F);
  const Tensor3<2, Number> C_inverse = dealii::invert(C);
  return -k_J * (C_inverse * grad_theta);
}

TEST(MaterialsOracle, HeatFlux)
{
  const Thermal thermal;
  RandomStates random;
  WorstErrors errors;
  for (unsigned int n = 0; n < n_states; ++n) {
    PointState<> state; // with the temperature gradient in the place of E
    state.F = random.deformation();
    state.E = random.uniform(0., 100.) * random.direction();
    state.theta = 293.;
    const HeatFlux<> ours = thermal.heat_flux(Kinematics<>(state.F), state.E);
    const PointState<Ad> ad = seeded(state);
    const Tensor3<1, Ad> Q = heat_flux(thermal.k, ad.F, ad.E);
    Tensor3<1> value;
    Tensor3<2> dQ_dgrad;
    Tensor3<3> dQ_dF;
    for (unsigned int J = 0; J < 3; ++J) {
      value[J] = Q[J].val();
      dQ_dgrad[J] = d_dE(Q[J]);
      dQ_dF[J] = d_dF(Q[J]);
    }
    // No floors: these are single terms, which do not cancel.
    errors.add("Q", ours.Q, value, 0.);
    errors.add("dQ/dgrad", ours.dQ_dgrad, dQ_dgrad, 0.);
    errors.add("dQ/dF", ours.dQ_dF, dQ_dF, 0.);
  }
  errors.expect_below(tolerance);
}

} // namespace
} // namespace thelma
