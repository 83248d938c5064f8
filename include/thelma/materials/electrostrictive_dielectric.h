#pragma once

#include <thelma/materials/permittivity.h>

#include <vector>

namespace thelma
{

/// Dielectric whose permittivity depends on deformation (theory.md, eq. 15), the tensor
///   eps (k I + c_1 B),   k = 1 - c_1 + c_2 (tr B - 3),   B = F F^T,
/// in the deformed body, to first order in B - I the most general one of an isotropic body. With
/// the true field g = F^{-T} E, d = F^{-1} g and Q = k g.g + c_1 E.E,
///   psi = -eps/2 J Q,   D = eps J (k d + c_1 E),
///   P = eps J (k g x d - Q/2 F^{-T} - c_2 g.g F).
class ElectrostrictiveDielectric : public Permittivity
{
public:
  static constexpr const char* name = "electrostrictive";
  static constexpr const char* meaning =
      "permittivity that depends on deformation, entry `Electrostriction`";

  void declare(dealii::ParameterHandler& prm)
  {
    Permittivity::declare(prm);
    prm.add_parameter("Electrostriction", c,
                      "c_1, c_2 of the permittivity eps (1 + c_1 (B - 1) + c_2 tr(B - 1)) of the "
                      "deformed body with B = F F^T. Default: an example, which loses 44 % when "
                      "stretched five times in its plane; take yours from capacitances of a film "
                      "at several stretches.",
                      dealii::Patterns::List(dealii::Patterns::Double(-10., 10.), 2, 2));
  }

  template <typename Number>
  Number psi(const PointState<Number>& state, const Kinematics<Number>& kin) const
  {
    return -eps.value(state.theta) / 2. * kin.J * Strained<Number>(*this, state, kin).Q;
  }

  template <typename Number>
  void add_first(const PointState<Number>& state, const Kinematics<Number>& kin,
                 FirstDerivatives<Number>& out) const
  {
    const Strained<Number> s(*this, state, kin);
    const Number eps_J = eps.value(state.theta) * kin.J;
    out.P += eps_J * s.stress(state, kin);
    out.D += eps_J * s.displacement(state);
    out.eta += eps.slope(state.theta) * kin.J * s.Q / 2.;
  }

  /// Beside what add_maxwell() has of psi = -eps/2 J Q at fixed k and E.E, with
  /// S = 2 g x d - g.g F^{-T}:
  ///   dP_iJ/dF_kL = eps J c_2 (F_iJ S_kL + S_iJ F_kL - g.g d_ik d_JL),
  ///   dP_iJ/dE_L = -eps J (c_1 E_L F^{-T}_iJ + 2 c_2 d_L F_iJ),   dD_I/dE_J = eps J c_1 d_IJ.
  template <typename Number>
  void add_second(const PointState<Number>& state, const Kinematics<Number>& kin,
                  SecondDerivatives<Number>& out) const
  {
    const Strained<Number> s(*this, state, kin);
    const Tensor3<2, Number>& F = state.F;
    const Number eps_J = eps.value(state.theta) * kin.J, slope_J = eps.slope(state.theta) * kin.J,
                 along = s.c_1 * eps_J, across = s.c_2 * eps_J;
    add_maxwell(s.field, kin, Number(eps_J * s.k), Number(eps_J * s.Q / 2.), out);
    Tensor3<2, Number> S;
    add_stress(s.field, kin, Number(2. * across), Number(across * s.field.square), S);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J) {
        out.dP_dF[i][J][i][J] -= across * s.field.square;
        for (unsigned int L = 0; L < 3; ++L) {
          out.dP_dE[i][J][L] -=
              along * state.E[L] * kin.G[i][J] + 2. * across * s.field.d[L] * F[i][J];
          for (unsigned int k = 0; k < 3; ++k)
            out.dP_dF[i][J][k][L] += F[i][J] * S[k][L] + S[i][J] * F[k][L];
        }
      }
    for (unsigned int I = 0; I < 3; ++I)
      out.dD_dE[I][I] += along;
    out.dP_dtheta += slope_J * s.stress(state, kin);
    out.dD_dtheta += slope_J * s.displacement(state);
    out.deta_dtheta += eps.curvature(state.theta) * kin.J * s.Q / 2.;
  }

private:
  template <typename Number>
  struct Strained {
    Strained(const ElectrostrictiveDielectric& law, const PointState<Number>& state,
             const Kinematics<Number>& kin)
        : field(state, kin), c_1(law.c[0]), c_2(law.c[1])
    {
      const Number tr = contract(state.F, state.F);
      k = 1. - c_1 + c_2 * (tr - 3.);
      require_positive(tr, kin);
      Q = k * field.square + c_1 * (state.E * state.E);
    }

    /// P/(eps J) and D/(eps J).
    Tensor3<2, Number> stress(const PointState<Number>& state, const Kinematics<Number>& kin) const
    {
      Tensor3<2, Number> result = Number(-c_2 * field.square) * state.F;
      add_stress(field, kin, k, Number(Q / 2.), result);
      return result;
    }
    Tensor3<1, Number> displacement(const PointState<Number>& state) const
    {
      return k * field.d + Number(c_1) * state.E;
    }

    TrueField<Number> field;
    double c_1, c_2;
    Number k, Q;

  private:
    /// Makes k no number where the permittivity is not positive in all directions, which its three
    /// invariants tell.
    void require_positive(const Number& tr, const Kinematics<Number>& kin)
    {
      const Number J2 = kin.J * kin.J, second = J2 * contract(kin.G, kin.G);
      const Number sum = 3. * k + c_1 * tr,
                   pairs = 3. * k * k + 2. * c_1 * k * tr + c_1 * c_1 * second,
                   product = k * k * (k + c_1 * tr) + c_1 * c_1 * (k * second + c_1 * J2);
      k += 0. * (positive(sum) + positive(pairs) + positive(product));
    }
  };

  std::vector<double> c{0., -0.00937};
};

} // namespace thelma
