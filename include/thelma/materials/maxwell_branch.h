#pragma once

#include <thelma/materials/neo_hookean.h>

namespace thelma
{

/// A spring of shear modulus G in series with a dashpot of relaxation time tau, at finite strain
/// (theory.md, eqs. 36 to 40). Its internal variable is C_v, symmetric with det C_v = 1, which
/// flows towards C = J^{-2/3} F^T F. A step of length dt ends where an incremental potential W is
/// least among all C_v of determinant 1: with b = 1 - a = dt/(tau + dt) and the old C_v,
///   N = a C_v + b C,   c = (det N)^{1/3},   C_v -> N/c,   W = 3 G/2 (c - 1)/b.
/// No step (b = 0) is elastic, W = G/2 (C : C_v^{-1} - 3); after infinite time (b = 1) W = 0.
class MaxwellBranch
{
public:
  static constexpr unsigned int n_history = 6; ///< components of C_v, see index()

  void declare(dealii::ParameterHandler& prm)
  {
    add_quantity(prm, "Branch modulus", G,
                 "G, by which a sudden deformation is stiffer than a slow one. Default: a branch "
                 "of VHB 4910, Wang, Decker, Henann and Chester (2016).",
                 Quantity("MPa", 0.));
    add_quantity(prm, "Relaxation time", tau,
                 "tau, in which the stress of the branch falls to 1/e at fixed deformation. "
                 "Outside a transient scene it has always relaxed.",
                 Quantity("s", 1e-12));
  }

  template <typename Number>
  Number W(const Tensor3<2, Number>& F, const Number& J,
           const PointHistory<Given<Number>>& history) const
  {
    return potential(Flow<Number>(*this, F, J, history));
  }

  /// Add W and W_F = G (T - m g), m = tr(B)/3, g = F^{-T} (theory.md, eq. 40).
  template <typename Number>
  void add_first(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                 const PointHistory<Given<Number>>& history, ElasticDerivatives<Number>& d) const
  {
    const Flow<Number> flow(*this, F, kin.J, history);
    const Stress<Number> stress(flow, F);
    d.W += potential(flow);
    d.W_F += G * (stress.T - stress.m * kin.G);
  }

  /// Add W_FF, which is G times, with h = b/c and
  /// Q = 2/3 (h B T - (1 + h m) T) + 1/3 (h (m^2 - B : B/3) + m) g,
  ///   2/3 h T_iJ T_kL + Q_iJ g_kL + g_iJ Q_kL + (d_ik - h B_ik) A_JL - h T_iL T_kJ + m g_iL g_kJ.
  template <typename Number>
  void add_second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                  const PointHistory<Given<Number>>& history, Tensor3<4, Number>& W_FF) const
  {
    const Flow<Number> flow(*this, F, kin.J, history);
    const Stress<Number> stress(flow, F);
    const Tensor3<2, Number>&T = stress.T, &B = stress.B, &A = stress.A, &g = kin.G;
    const Number h = flow.b / flow.c, m = stress.m;
    const Number of_T = -2. / 3. * (1. + h * m),
                 of_g = (h * (m * m - contract(B, B) / 3.) + m) / 3., two_thirds = 2. / 3. * h;
    const Tensor3<2, Number> BT = B * T;
    const Tensor3<2, Number> Q = two_thirds * BT + of_T * T + of_g * g;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int L = 0; L < 3; ++L) {
            const Number mobility = (i == k ? 1. : 0.) - h * B[i][k];
            W_FF[i][J][k][L] +=
                G * (two_thirds * T[i][J] * T[k][L] + Q[i][J] * g[k][L] + g[i][J] * Q[k][L] +
                     mobility * A[J][L] - h * T[i][L] * T[k][J] + m * g[i][L] * g[k][J]);
          }
  }

  void update_history(const Tensor3<2>& F, const PointHistory<>& history, double* now) const
  {
    const Flow<double> flow(*this, F, Kinematics<>(F).J, history);
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

  /// A step of C_v, from the old one.
  template <typename Number>
  struct Flow {
    Flow(const MaxwellBranch& branch, const Tensor3<2, Number>& F, const Number& J,
         const PointHistory<Given<Number>>& history)
        : a(1. / (1. + history.dt() / branch.tau)), b(1. - a)
    {
      using std::exp;
      using std::log;
      j = exp(-2. / 3. * log(J));
      C = j * (dealii::transpose(F) * F);
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int k = 0; k < 3; ++k)
          C_v[i][k] = history.old ? Number(history.old[index(i, k)]) : Number(i == k ? 1. : 0.);
      N = a * C_v + b * C;
      const Kinematics<Number> kin(N);
      c = exp(log(kin.J) / 3.);
      N_inverse = kin.G;
    }

    double a, b;
    Number j, c; ///< J^{-2/3}, (det N)^{1/3}
    Tensor3<2, Number> C, C_v, N, N_inverse;
  };

  /// W of theory.md, eq. 39: c^3 - 1 = b y, whose digits survive where b is small.
  template <typename Number>
  Number potential(const Flow<Number>& flow) const
  {
    const Number I_1 = contract(Kinematics<Number>(flow.C_v).G, flow.C),
                 I_2 = contract(Kinematics<Number>(flow.C).G, flow.C_v),
                 y = flow.a * (flow.a * (I_1 - 3.) + flow.b * (I_2 - 3.));
    return 1.5 * G * y / (1. + flow.c + flow.c * flow.c);
  }

  /// With the new C_v: A = j C_v^{-1}, T = F A, and the elastic strain B = T F^T, 1 at rest.
  template <typename Number>
  struct Stress {
    Stress(const Flow<Number>& flow, const Tensor3<2, Number>& F)
        : A(flow.j * flow.c * flow.N_inverse), T(F * A), B(T * dealii::transpose(F)),
          m(dealii::trace(B) / 3.)
    {
    }

    Tensor3<2, Number> A, T, B;
    Number m;
  };

  double G = 0.02653, tau = 6.56; ///< MPa, s
};

/// NeoHookean with a MaxwellBranch beside it. What flow dissipates does not heat the body yet: the
/// structural heat of a transient scene is refused (MaterialLibrary::check_flow).
class NeoHookeanWithBranch : public NeoHookean
{
public:
  static constexpr const char* name = "neo-Hookean with Maxwell branch";
  static constexpr const char* meaning =
      "viscoelastic: a second spring that relaxes, entries `Branch modulus`, `Relaxation time`";
  static constexpr unsigned int n_history = MaxwellBranch::n_history;

  void declare(dealii::ParameterHandler& prm)
  {
    NeoHookean::declare(prm);
    branch.declare(prm);
  }

  template <typename Number>
  Number W(const Tensor3<2, Number>& F, const Number& J, const Number& theta,
           const PointHistory<Given<Number>>& history) const
  {
    return NeoHookean::W(F, J, theta) + branch.W(F, J, history);
  }

  template <typename Number>
  ElasticDerivatives<Number> first(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                                   const Number& theta,
                                   const PointHistory<Given<Number>>& history) const
  {
    ElasticDerivatives<Number> d = NeoHookean::first(F, kin, theta);
    branch.add_first(F, kin, history, d);
    return d;
  }

  template <typename Number>
  Tensor3<4, Number> second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                            const Number& theta, const PointHistory<Given<Number>>& history) const
  {
    Tensor3<4, Number> W_FF = NeoHookean::second(F, kin, theta);
    branch.add_second(F, kin, history, W_FF);
    return W_FF;
  }

  void update_history(const Tensor3<2>& F, const PointHistory<>& history, double* now) const
  {
    branch.update_history(F, history, now);
  }

private:
  MaxwellBranch branch;
};

} // namespace thelma
