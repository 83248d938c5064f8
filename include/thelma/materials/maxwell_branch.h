#pragma once

#include <thelma/materials/point.h>
#include <thelma/materials/relaxation_time.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace thelma
{

/// What all branches of a point share: C_iso = j F^T F with j = J^{-2/3}.
template <typename Number>
struct IsochoricStrain {
  IsochoricStrain(const Tensor3<2, Number>& F, const Number& J)
  {
    using std::exp;
    using std::log;
    j = exp(-2. / 3. * log(J));
    C = j * (dealii::transpose(F) * F);
  }

  Number j;
  Tensor3<2, Number> C;
};

/// A spring of shear modulus G(theta) in series with a dashpot of relaxation time tau(theta), at
/// finite strain (theory.md, eqs. 36 to 41). Its internal variable is C_v, symmetric with det C_v =
/// 1, which flows towards C_iso. With the rate r (C_v - K) of C_v by backward differences, a step
/// ends where an incremental potential W is least among all C_v of determinant 1: with
/// b = 1 - a = 1/(1 + r tau),
///   N = a K + b C_iso,   c = (det N)^{1/3},   C_v = N/c,   W = 3 G/2 c/b + const.
/// Without time (r = infinity, b = 0) it is elastic, W = G/2 (C_iso : C_v^{-1} - 3); after infinite
/// time (r = 0, b = 1) W is constant.
class MaxwellBranch
{
public:
  static constexpr const char* name = "Maxwell";
  static constexpr const char* meaning =
      "neo-Hookean spring and viscous element in series, entries `Modulus`, `Relaxation time`";
  static constexpr unsigned int n_history = 6; ///< components of C_v, see index()

  void declare(dealii::ParameterHandler& prm)
  {
    G.declare(prm, "Modulus", "G(theta), by which a sudden deformation is stiffer than a slow one.",
              Quantity("MPa"));
    tau.declare(prm);
  }

  /// What does not allow @p theta; empty if all is well.
  std::string defect(const double theta) const
  {
    if (!(G.value(theta) >= 0.))
      return "Modulus";
    return tau.is_defined(theta) && tau.value(theta) > 0. ? "" : "Relaxation time";
  }

  double modulus(const double theta) const { return G.value(theta); }

  /// K = old + q (old - older), the old C_v of differences of first order where this is not
  /// positive definite, as after a jump.
  static void begin_step(const double* old, const double* older, const double q, double* K)
  {
    for (unsigned int i = 0; i < n_history; ++i)
      K[i] = old[i] + q * (old[i] - older[i]);
    const double minor = K[0] * K[1] - K[3] * K[3];
    const double det =
        K[2] * minor - K[0] * K[5] * K[5] - K[1] * K[4] * K[4] + 2. * K[3] * K[4] * K[5];
    if (!(K[0] > 0. && minor > 0. && det > 0.))
      std::copy(old, old + n_history, K);
  }

  /// The incremental potential, but for a constant.
  template <typename Number>
  Number W(const IsochoricStrain<Number>& strain, const Number& theta,
           const PointHistory<Given<Number>>& history) const
  {
    const Flow<Number> flow(*this, strain, theta, history);
    if (history.is_instant())
      return stored(flow, strain, theta);
    return 1.5 * G.value(theta) * flow.c / flow.b;
  }

  /// Add what is stored, w = G/2 (C_iso : C_v^{-1} - 3), and the derivatives of W,
  /// W_F = G (T - m g) with m = tr(B)/3, g = F^{-T} (theory.md, eq. 41).
  template <typename Number>
  void add_first(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                 const IsochoricStrain<Number>& strain, const Number& theta,
                 const PointHistory<Given<Number>>& history, ElasticDerivatives<Number>& d) const
  {
    const Flow<Number> flow(*this, strain, theta, history);
    const Stress<Number> stress(flow, strain, F);
    const Number modulus = G.value(theta), slope = G.slope(theta), I = (3. * stress.m - 3.) / 2.;
    const Tensor3<2, Number> P = stress.T - stress.m * kin.G;
    d.W += modulus * I;
    d.W_theta += slope * I;
    d.W_thetatheta += G.curvature(theta) * I;
    d.W_F += modulus * P;
    d.W_Ftheta += slope * P - modulus * flow.b * flow.a * tau.log_slope(theta) *
                                  shift_of_stress(flow, stress, strain, F, kin);
  }

  /// Add W_FF, which is G times, with h = b/c and
  /// Q = 2/3 (h B T - (1 + h m) T) + 1/3 (h (m^2 - B : B/3) + m) g,
  ///   2/3 h T_iJ T_kL + Q_iJ g_kL + g_iJ Q_kL + (d_ik - h B_ik) A_JL - h T_iL T_kJ + m g_iL g_kJ.
  template <typename Number>
  void add_second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                  const IsochoricStrain<Number>& strain, const Number& theta,
                  const PointHistory<Given<Number>>& history, Tensor3<4, Number>& W_FF) const
  {
    const Flow<Number> flow(*this, strain, theta, history);
    const Stress<Number> stress(flow, strain, F);
    const Tensor3<2, Number>&B = stress.B, &g = kin.G;
    const Number h = flow.b / flow.c, m = stress.m, modulus = G.value(theta);
    const Number of_T = -2. / 3. * (1. + h * m),
                 of_g = (h * (m * m - contract(B, B) / 3.) + m) / 3.;
    const Tensor3<2, Number> BT = B * stress.T, T = modulus * stress.T, A = modulus * stress.A;
    const Tensor3<2, Number> Q = 2. / 3. * modulus * h * BT + of_T * T + modulus * of_g * g;
    const Tensor3<2, Number> hT = h * stress.T, mg = modulus * m * g;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        for (unsigned int k = 0; k < 3; ++k) {
          const Number mobility = (i == k ? 1. : 0.) - h * B[i][k];
          for (unsigned int L = 0; L < 3; ++L)
            W_FF[i][J][k][L] += 2. / 3. * hT[i][J] * T[k][L] + Q[i][J] * g[k][L] +
                                g[i][J] * Q[k][L] + mobility * A[J][L] - hT[i][L] * T[k][J] +
                                mg[i][L] * g[k][J];
        }
  }

  /// C_v at the end of the step.
  void update_history(const IsochoricStrain<double>& strain, const double theta,
                      const PointHistory<>& history, double* now) const
  {
    const Flow<double> flow(*this, strain, theta, history);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        now[index(i, j)] = flow.N[i][j] / flow.c;
  }

private:
  /// Where a component of a symmetric tensor stands: 00 11 22 01 02 12.
  static constexpr unsigned int index(const unsigned int i, const unsigned int j)
  {
    return i == j ? i : i + j + 2;
  }

  /// A step of C_v.
  template <typename Number>
  struct Flow {
    Flow(const MaxwellBranch& branch, const IsochoricStrain<Number>& strain, const Number& theta,
         const PointHistory<Given<Number>>& history)
    {
      using std::exp;
      using std::log;
      if (!history.is_instant())
        b = 1. / (1. + history.rate * branch.tau.value(theta));
      a = 1. - b;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int k = 0; k < 3; ++k)
          K[i][k] = history.old ? Number(history.old[index(i, k)]) : Number(i == k ? 1. : 0.);
      N = a * K + b * strain.C;
      const Kinematics<Number> kin(N);
      c = exp(log(kin.J) / 3.);
      N_inverse = kin.G;
    }

    Number b = 0., a, c; ///< c = (det N)^{1/3}
    Tensor3<2, Number> K, N, N_inverse;
  };

  /// With the new C_v: A = j C_v^{-1}, T = F A, and the elastic strain B = T F^T, 1 at rest.
  template <typename Number>
  struct Stress {
    Stress(const Flow<Number>& flow, const IsochoricStrain<Number>& strain,
           const Tensor3<2, Number>& F)
        : A(strain.j * flow.c * flow.N_inverse), T(F * A), B(T * dealii::transpose(F)),
          m(dealii::trace(B) / 3.)
    {
    }

    Tensor3<2, Number> A, T, B;
    Number m;
  };

  template <typename Number>
  Number stored(const Flow<Number>& flow, const IsochoricStrain<Number>& strain,
                const Number& theta) const
  {
    return G.value(theta) / 2. * (flow.c * contract(flow.N_inverse, strain.C) - 3.);
  }

  /// dT/db - dm/db g of another mobility at the same F: C_v' = (N' - C_v tr(N^{-1} N')/3 c)/c with
  /// N' = C_iso - K, and A' = -A C_v' A/j.
  template <typename Number>
  Tensor3<2, Number> shift_of_stress(const Flow<Number>& flow, const Stress<Number>& stress,
                                     const IsochoricStrain<Number>& strain,
                                     const Tensor3<2, Number>& F,
                                     const Kinematics<Number>& kin) const
  {
    const Tensor3<2, Number> change = strain.C - flow.K;
    const Number mean = contract(flow.N_inverse, change) / 3.;
    const Tensor3<2, Number> C_v = (change - mean * flow.N) / flow.c;
    const Tensor3<2, Number> T = -1. / strain.j * (stress.T * C_v * stress.A);
    return T - contract(T, F) / 3. * kin.G;
  }

  TemperatureLaw G{{0.02653}}; ///< MPa; VHB 4910, Wang, Decker, Henann and Chester (2016)
  RelaxationTime tau;
};

} // namespace thelma
