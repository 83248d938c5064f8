#pragma once

#include <thelma/materials/flow_heat.h>
#include <thelma/materials/maxwell_step.h>
#include <thelma/materials/relaxation_time.h>
#include <thelma/materials/strain_history.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace thelma
{

/// A spring of shear modulus G(theta) in series with a dashpot of relaxation time tau(theta), at
/// finite strain (theory.md, eqs. 45 to 50). Its internal variable is C_v, symmetric with det C_v =
/// 1, which flows towards C_iso. A step ends where an incremental potential W is least among all
/// C_v of determinant 1: with what history makes of the step, MaxwellStep,
///   N = start + w C_iso,   c = (det N)^{1/3},   C_v = N/c,   W = 3 G/2 c/w + const.
/// Without time (w = 0) it is elastic, W = G/2 (C_iso : C_v^{-1} - 3).
class MaxwellBranch
{
public:
  static constexpr const char* name = "Maxwell";
  static constexpr const char* meaning =
      "neo-Hookean spring and viscous element in series, entries `Modulus`, `Relaxation time`";
  static constexpr unsigned int n_history = n_symmetric;  ///< C_v
  static constexpr unsigned int n_step = n_symmetric + 1; ///< MaxwellStep: start, weight

  void declare(dealii::ParameterHandler& prm)
  {
    G.declare(prm, "Modulus", "G(theta), by which a sudden deformation is stiffer than a slow one.",
              Quantity("MPa"));
    tau.declare(prm);
  }

  std::string table_defect(const double theta) const
  {
    const std::string first = G.table_defect(theta);
    return first.empty() ? tau.table_defect(theta) : first;
  }

  /// The entry that does not allow @p theta; empty if all is well.
  std::string defect(const double theta) const
  {
    if (!(G.value(theta) >= 0.))
      return "Modulus";
    return tau.value(theta) > 0. ? "" : "Relaxation time";
  }

  double modulus(const double theta) const { return G.value(theta); }

  /// The step from the @p old values of the point and of C_v.
  void begin_step(const StrainHistory& strain, const double* old, double* step) const
  {
    const MaxwellStep now = flow(strain, old);
    put_symmetric(now.start, step);
    step[n_symmetric] = now.weight;
  }

  /// Without any time to flow; @p old is null in the body at rest.
  static void stand_still(const double* old, double* step)
  {
    put_symmetric(old ? symmetric(old) : rest(), step);
    step[n_symmetric] = 0.;
  }

  /// What the step has done wrong to C_v, which is @p now.
  double error(const StrainHistory& strain, const double* old, const double* now) const
  {
    const Tensor3<2> C_v = symmetric(old), C_v_end = symmetric(now);
    const MaxwellStep step = exponential(strain, old);
    if (strain.order == 1)
      return (C_v_end - end_of(step, strain.C_iso)).norm();
    const double slip =
        (1. / tau.value(strain.theta_old) + 1. / tau.value(strain.theta)) / (2. * rate(strain)) -
        1.;
    return error_of(step, C_v, strain.C_iso_old, strain.C_iso, C_v_end, strain.bend(), slip);
  }

  /// The incremental potential, but for a constant.
  template <typename Number>
  Number W(const IsochoricStrain<Number>& strain, const Number& theta,
           const Given<Number>* step) const
  {
    const Flow<Number> end(strain, step);
    if (end.w == 0.)
      return G.value(theta) / 2. * (end.c * contract(end.N_inverse, strain.C) - 3.);
    return 1.5 * G.value(theta) * end.c / end.w;
  }

  /// Add what is stored, w = G/2 (C_iso : C_v^{-1} - 3), and the derivatives of W,
  /// W_F = G (T - m g) with m = tr(B)/3, g = F^{-T} (theory.md, eq. 50).
  template <typename Number>
  void add_first(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                 const IsochoricStrain<Number>& strain, const Number& theta,
                 const Given<Number>* step, ElasticDerivatives<Number>& d) const
  {
    add_first(Stress<Number>(Flow<Number>(strain, step), strain, F), kin, theta, d);
  }

  /// The same, and add W_FF, which is G times, with h = w/c and
  /// Q = 2/3 (h B T - (1 + h m) T) + 1/3 (h (m^2 - B : B/3) + m) g,
  ///   2/3 h T_iJ T_kL + Q_iJ g_kL + g_iJ Q_kL + (d_ik - h B_ik) A_JL - h T_iL T_kJ + m g_iL g_kJ.
  template <typename Number>
  void add_second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                  const IsochoricStrain<Number>& strain, const Number& theta,
                  const Given<Number>* step, ElasticDerivatives<Number>& d,
                  Tensor3<4, Number>& W_FF) const
  {
    const Flow<Number> end(strain, step);
    const Stress<Number> stress(end, strain, F);
    add_first(stress, kin, theta, d);
    const Tensor3<2, Number>&B = stress.B, &g = kin.G;
    const Number h = end.w / end.c, m = stress.m, modulus = G.value(theta);
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

  /// A state of the branch.
  template <typename Number = double>
  struct Flowed {
    Flowed(const Tensor3<2, Number>& C_iso, const Tensor3<2, Number>& C_v_inverse,
           const Number& theta)
        : C_iso(C_iso), theta(theta), I(contract(C_iso, C_v_inverse)),
          S(C_v_inverse - I / 3. * dealii::invert(C_iso))
    {
    }

    /// Of what a point remembers: its strain and temperature, and C_v.
    Flowed(const double* point, const double* own)
        : Flowed(symmetric(point), dealii::invert(symmetric(own)), point[n_symmetric])
    {
    }

    Tensor3<2, Number> C_iso;
    Number theta, I;      ///< I = C_iso : C_v^{-1}
    Tensor3<2, Number> S; ///< stress over G, without what no isochoric strain feels
  };

  /// At the end of a step.
  template <typename Number>
  Flowed<Number> flowed(const IsochoricStrain<Number>& strain, const Number& theta,
                        const Given<Number>* step) const
  {
    const Flow<Number> end(strain, step);
    return {strain.C, end.c * end.N_inverse, theta};
  }

  /// Add theta_0 times what is dissipated between two states (theory.md, eq. 52).
  template <typename Number>
  void add_dissipated(const Flowed<>& start, const Flowed<Number>& end,
                      Dissipated<Number>& sum) const
  {
    const Tensor3<2, Number> way = end.C_iso - Tensor3<2, Number>(start.C_iso);
    const Number lost = start.I - end.I,
                 early = G.value(start.theta) / 4. *
                         (lost + contract(Tensor3<2, Number>(start.S), way)),
                 late = G.value(end.theta) / 4. * (lost + contract(end.S, way));
    sum.energy += start.theta * early + end.theta * late;
    sum.entropy += early + late;
  }

  /// C_v at the end of the step; at the strain itself where it has relaxed (@p step is null).
  static void update_history(const IsochoricStrain<double>& strain, const double* step, double* now)
  {
    if (!step)
      return put_symmetric(strain.C, now);
    const Flow<double> end(strain, step);
    put_symmetric(end.N / end.c, now);
  }

private:
  /// The end of a step.
  template <typename Number>
  struct Flow {
    Flow(const IsochoricStrain<Number>& strain, const Given<Number>* step) : w(step[n_symmetric])
    {
      using std::exp;
      using std::log;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int k = 0; k < 3; ++k)
          N[i][k] = step[symmetric_index(i, k)] + w * strain.C[i][k];
      const Kinematics<Number> kin(N);
      c = exp(log(kin.J) / 3.);
      N_inverse = kin.G;
    }

    Number w, c; ///< c = (det N)^{1/3}
    Tensor3<2, Number> N, N_inverse;
  };

  /// With the new C_v: A = j C_v^{-1}, T = F A, and the elastic strain B = T F^T, 1 at rest.
  template <typename Number>
  struct Stress {
    Stress(const Flow<Number>& end, const IsochoricStrain<Number>& strain,
           const Tensor3<2, Number>& F)
        : A(strain.j * end.c * end.N_inverse), T(F * A), B(T * dealii::transpose(F)),
          m(dealii::trace(B) / 3.)
    {
    }

    Tensor3<2, Number> A, T, B;
    Number m;
  };

  template <typename Number>
  void add_first(const Stress<Number>& stress, const Kinematics<Number>& kin, const Number& theta,
                 ElasticDerivatives<Number>& d) const
  {
    const Number modulus = G.value(theta), slope = G.slope(theta), I = (3. * stress.m - 3.) / 2.;
    const Tensor3<2, Number> P = stress.T - stress.m * kin.G;
    d.W += modulus * I;
    d.W_theta += slope * I;
    d.W_thetatheta += G.curvature(theta) * I;
    d.W_F += modulus * P;
    d.W_Ftheta += slope * P;
  }

  static Tensor3<2> rest() { return Tensor3<2>(dealii::unit_symmetric_tensor<3>()); }

  /// Mean of 1/tau over the step, as the last steps foretell it.
  double rate(const StrainHistory& strain) const
  {
    constexpr double most = 2.;
    const double old = 1. / tau.value(strain.theta_old);
    if (!(strain.dt_before > 0.))
      return old;
    const double slope = (old - 1. / tau.value(strain.theta_older)) / strain.dt_before;
    return std::clamp(old + strain.dt / 2. * slope, old / most, most * old);
  }

  MaxwellStep exponential(const StrainHistory& strain, const double* old) const
  {
    return exponential_step(symmetric(old), strain.C_iso_old, strain.dt * rate(strain));
  }

  MaxwellStep flow(const StrainHistory& strain, const double* old) const
  {
    return strain.order == 1 ? first_order_step(symmetric(old), strain.dt * rate(strain))
                             : exponential(strain, old);
  }

  TemperatureLaw G{{0.02653}}; ///< MPa; VHB 4910, Wang, Decker, Henann and Chester (2016)
  RelaxationTime tau;
};

} // namespace thelma
