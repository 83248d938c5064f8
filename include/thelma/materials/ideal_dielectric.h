#pragma once

#include <thelma/materials/permittivity.h>

namespace thelma
{

/// Ideal dielectric (theory.md, eq. 14), with the true field g = F^{-T} E and d = F^{-1} g:
///   psi = -eps/2 J C^{-1} : E x E = -eps/2 J g.g,   D = eps J d,
///   P = eps J (g x d - g.g/2 F^{-T}).
class IdealDielectric : public Permittivity
{
public:
  static constexpr const char* name = "ideal";
  static constexpr const char* meaning = "permittivity independent of deformation and field";

  template <typename Number>
  Number psi(const PointState<Number>& state, const Kinematics<Number>& kin) const
  {
    return -eps.value(state.theta) / 2. * kin.J * TrueField<Number>(state, kin).square;
  }

  template <typename Number>
  void add_first(const PointState<Number>& state, const Kinematics<Number>& kin,
                 FirstDerivatives<Number>& out) const
  {
    const TrueField<Number> field(state, kin);
    const Number eps_J = eps.value(state.theta) * kin.J, half = field.square / 2.;
    add_maxwell(field, kin, eps_J, Number(eps_J * half), out);
    out.eta += eps.slope(state.theta) * kin.J * half;
  }

  template <typename Number>
  void add_second(const PointState<Number>& state, const Kinematics<Number>& kin,
                  SecondDerivatives<Number>& out) const
  {
    const TrueField<Number> field(state, kin);
    const Number eps_J = eps.value(state.theta) * kin.J, half = field.square / 2.,
                 slope_J = eps.slope(state.theta) * kin.J;
    add_maxwell(field, kin, eps_J, Number(eps_J * half), out);
    add_stress(field, kin, slope_J, Number(slope_J * half), out.dP_dtheta);
    out.dD_dtheta += slope_J * field.d;
    out.deta_dtheta += eps.curvature(state.theta) * kin.J * half;
  }
};

} // namespace thelma
