#include "support.h"

/// The law of the paper (Sharma, Khurana, Joglekar) against its constitutive equations, index by
/// index, and Sacado on its energy, with the errata of theory.md corrected. Here "eq." is an
/// equation of the paper.
namespace thelma
{
namespace
{

using namespace material_tests;

/// The law of the paper with its mu(theta) and permittivity. The rest is chosen so that no term
/// hides behind another (K = 1000 mu and the c of acrylic make some 10^4 times their neighbours).
std::unique_ptr<PaperMaterial> paper_material()
{
  auto material = std::make_unique<PaperMaterial>();
  material->thermal.K = 1.;
  material->thermal.alpha = 1e-3;
  material->thermal.c = 0.01;
  return material;
}

/// Agreement of two routes to the same formula.
constexpr double agrees = 1e-12;

template <class Block>
double relative_error(const Block& ours, const Block& exact)
{
  return (ours - exact).norm() / exact.norm();
}

double relative_error(const double ours, const double exact)
{
  return std::abs((ours - exact) / exact);
}

/// eq. 7
template <typename Number>
Number energy(const Thermal& t, const PointState<Number>& state)
{
  const Number x = 1000. / state.theta;
  const Number mu = (0.2001 * x * x - 1.078 * x + 1.5180) / 3.;
  const Number rise = state.theta - t.theta_0;
  const Number J_theta = exp(3. * t.alpha * rise), ln_J_theta = 3. * t.alpha * rise;
  const Tensor3<2, Number> C = dealii::transpose(state.F) * state.F;
  const Number J = dealii::determinant(state.F), ln_J_EM = log(J / J_theta);
  const Number trace = dealii::trace(C) * exp(-2. / 3. * ln_J_theta);
  return state.theta / t.theta_0 *
             (mu / 2. * (trace - 3. - 2. * ln_J_EM) + t.K / 2. * ln_J_EM * ln_J_EM) -
         3.98e-5 / 2. * J * (state.E * (dealii::invert(C) * state.E)) +
         t.c * (rise - state.theta * log(state.theta / t.theta_0)) -
         3. * t.alpha * t.K * rise * ln_J_theta / J_theta;
}

/// The symbols of the paper at a state.
struct Symbols : PointState<> {
  Symbols(const PaperMaterial& material, const PointState<>& state)
      : PointState<>(state), t(material.thermal), f(theta / t.theta_0),
        mu(material.shear_modulus(theta)), J(dealii::determinant(F)),
        ln_J_theta(3. * t.alpha * (theta - t.theta_0)), J_theta(std::exp(ln_J_theta)),
        ln_J_EM(std::log(J) - ln_J_theta), C_inv(dealii::invert(dealii::transpose(F) * F)),
        CE(C_inv * E)
  {
    const double x = 1000. / theta;
    mu_slope = -(2. * 0.2001 * x * x - 1.078 * x) / (3. * theta);
    trace_C_EM = std::pow(J_theta, -2. / 3.) * contract(F, F);
  }

  const Thermal& t;
  double f, mu, J, ln_J_theta, J_theta, ln_J_EM, mu_slope, trace_C_EM;
  double eps = 3.98e-5;
  Tensor3<2> C_inv, I = dealii::unit_symmetric_tensor<3>();
  Tensor3<1> CE; ///< C^{-1}_PQ E_Q
};

class PaperEquations : public testing::Test
{
protected:
  const std::unique_ptr<PaperMaterial> material = paper_material();
  const Total<PaperMaterial> law = total(*material);
  const Symbols s{*material, some_state};
  const FirstDerivatives<> ours = law.first(some_state);
  const SecondDerivatives<> tangent = law.second(some_state);
  const FirstDerivatives<> exact =
      derivatives_of_energy(energy(material->thermal, seeded(some_state)));
};

/// Without expansion heating from theta_0 to 340 K raises the entropy by c ln(340/theta_0).
TEST_F(PaperEquations, HeatCapacity)
{
  Thermal thermal = material->thermal;
  thermal.alpha = 0.;
  EXPECT_NEAR(thermal.eta(s.theta), thermal.c * std::log(s.f), 1e-15);
  EXPECT_NEAR(s.theta * thermal.deta_dtheta(s.theta), thermal.c, 1e-15);
}

/// eq. 10
double entropy(const Symbols& s)
{
  const double alpha = s.t.alpha, K = s.t.K, rise = s.theta - s.t.theta_0;
  const double invariant = s.trace_C_EM - 3. - 2. * s.ln_J_EM;
  const double elastic =
      -1. / s.t.theta_0 * (s.mu / 2. * invariant + K / 2. * s.ln_J_EM * s.ln_J_EM) -
      s.f * (s.mu / 2. * (6. * alpha - 2. * alpha * s.trace_C_EM) - 3. * alpha * K * s.ln_J_EM +
             s.mu_slope / 2. * invariant);
  const double thermal = 3. * alpha * K * s.ln_J_theta / s.J_theta +
                         9. * alpha * alpha * K * rise * (1. - s.ln_J_theta) / s.J_theta;
  return elastic + s.t.c * std::log(s.f) + thermal;
}

TEST_F(PaperEquations, Entropy)
{
  EXPECT_LT(relative_error(ours.eta, exact.eta), agrees);
  EXPECT_LT(relative_error(ours.eta, entropy(s)), agrees);
}

/// A_iJkL = d_ik S_JL + F_iI F_kK S_IJKL, the form of eq. 20.
template <typename Second, typename Fourth>
Tensor3<4> pushed_forward(const Tensor3<2>& F, const Second& S_JL, const Fourth& S_IJKL)
{
  Tensor3<4> A;
  for (int i = 0; i < 3; ++i)
    for (int J = 0; J < 3; ++J)
      for (int k = 0; k < 3; ++k)
        for (int L = 0; L < 3; ++L) {
          A[i][J][k][L] = i == k ? S_JL(J, L) : 0.;
          for (int I = 0; I < 3; ++I)
            for (int K = 0; K < 3; ++K)
              A[i][J][k][L] += F[i][I] * F[k][K] * S_IJKL(I, J, K, L);
        }
  return A;
}

/// eq. 20
Tensor3<4> dP_dF(const Symbols& s)
{
  const Tensor3<2>& C = s.C_inv;
  const Tensor3<1>& d = s.CE;
  const double EE = s.E * d, eps_J = s.eps * s.J, K_ln_J = s.t.K * s.ln_J_EM;
  const auto S_JL = [&](const int J, const int L) {
    return s.f * (s.mu * (std::pow(s.J_theta, -2. / 3.) * s.I[J][L] - C[J][L]) + K_ln_J * C[J][L]) +
           eps_J * (d[J] * d[L] - EE / 2. * C[J][L]);
  };
  const auto S_IJKL = [&](const int I, const int J, const int K, const int L) {
    const double pairs = C[I][K] * C[J][L] + C[I][L] * C[J][K];
    double S = s.f * ((s.mu - K_ln_J) * pairs + s.t.K * C[I][J] * C[K][L]);
    S += eps_J * C[K][L] * (d[I] * d[J] - EE / 2. * C[I][J]);
    S += eps_J * (EE / 2. * pairs + C[I][J] * d[K] * d[L]);
    S -= eps_J * d[I] * (C[J][K] * d[L] + C[J][L] * d[K]);
    return S - eps_J * d[J] * (C[I][K] * d[L] + C[I][L] * d[K]);
  };
  return pushed_forward(s.F, S_JL, S_IJKL);
}

TEST_F(PaperEquations, SlopeOfTheStressByF)
{
  EXPECT_LT(relative_error(tangent.dP_dF, dP_dF(s)), agrees);
}

/// eq. 22
TEST_F(PaperEquations, SlopeOfTheStressByTemperature)
{
  const double J23 = std::pow(s.J_theta, -2. / 3.), alpha = s.t.alpha;
  const Tensor3<2> volume = J23 * s.I - s.C_inv;
  const Tensor3<2> bracket = s.mu * volume + s.t.K * s.ln_J_EM * s.C_inv;
  const Tensor3<2> expansion = 2. * s.mu * alpha * J23 * s.I + 3. * alpha * s.t.K * s.C_inv;
  const Tensor3<2> dP_dtheta =
      s.F * (1. / s.t.theta_0 * bracket - s.f * expansion + s.f * s.mu_slope * volume);
  EXPECT_LT(relative_error(tangent.dP_dtheta, dP_dtheta), agrees);
}

/// eqs. 8, 9, 21, 23 and 24
TEST_F(PaperEquations, StressAndDisplacement)
{
  const Tensor3<2>& C = s.C_inv;
  const Tensor3<1>& d = s.CE;
  const double EE = s.E * d, eps_J = s.eps * s.J;
  Tensor3<2> S;
  Tensor3<3> dP_dE, dD_dF;
  for (int I = 0; I < 3; ++I)
    for (int J = 0; J < 3; ++J) {
      S[I][J] = s.f * (s.mu * (std::pow(s.J_theta, -2. / 3.) * s.I[I][J] - C[I][J]) +
                       s.t.K * s.ln_J_EM * C[I][J]) +
                eps_J * (d[I] * d[J] - C[I][J] * EE / 2.);
      for (int L = 0; L < 3; ++L)
        for (int i = 0; i < 3; ++i) {
          dP_dE[i][J][L] += eps_J * (C[L][I] * d[J] + d[I] * C[L][J] - d[L] * C[I][J]) * s.F[i][I];
          dD_dF[J][i][L] += eps_J * (d[J] * C[I][L] - C[J][I] * d[L] - C[J][L] * d[I]) * s.F[i][I];
        }
    }
  EXPECT_LT(relative_error(ours.P, exact.P), agrees);
  EXPECT_LT(relative_error(ours.P, Tensor3<2>(s.F * S)), agrees);
  EXPECT_LT(relative_error(ours.D, exact.D), agrees);
  EXPECT_LT(relative_error(ours.D, Tensor3<1>(eps_J * d)), agrees);
  EXPECT_LT(relative_error(tangent.dD_dE, Tensor3<2>(eps_J * C)), agrees);
  EXPECT_LT(relative_error(tangent.dP_dE, dP_dE), agrees);
  for (int J = 0; J < 3; ++J)
    for (int i = 0; i < 3; ++i)
      for (int L = 0; L < 3; ++L)
        EXPECT_NEAR(dD_dF[J][i][L], -tangent.dP_dE[i][L][J], agrees * dD_dF.norm());
}

/// eqs. 11, 24 and 25; the vector E serves as temperature gradient.
TEST_F(PaperEquations, HeatFlux)
{
  const HeatFlux<> flux = s.t.heat_flux(Kinematics<>(s.F), s.E);
  const Tensor3<2>& C = s.C_inv;
  const Tensor3<1>& d = s.CE;
  const double k_J = s.t.k * s.J;
  Tensor3<3> dQ_dF;
  for (int J = 0; J < 3; ++J)
    for (int k = 0; k < 3; ++k)
      for (int L = 0; L < 3; ++L)
        for (int K = 0; K < 3; ++K)
          dQ_dF[J][k][L] += k_J * (C[J][K] * d[L] + C[J][L] * d[K] - d[J] * C[K][L]) * s.F[k][K];
  EXPECT_LT(relative_error(flux.Q, Tensor3<1>(-k_J * d)), agrees);
  EXPECT_LT(relative_error(flux.dQ_dgrad, Tensor3<2>(-k_J * C)), agrees);
  EXPECT_LT(relative_error(flux.dQ_dF, dQ_dF), agrees);
}

} // namespace
} // namespace thelma
