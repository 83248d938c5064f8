#pragma once

#include <thelma/materials/langevin.h>
#include <thelma/materials/permittivity.h>

namespace thelma
{

/// Dielectric whose dipoles align (theory.md, eq. 16): the polarisation is that of Langevin,
///   psi = -J Phi,   Phi = eps_0/2 g.g + P_s^2/(3 chi) ln(sinh x/x),   x = 3 chi |g|/P_s,
/// with the true field g = F^{-T} E, eps_0 of vacuum and chi = eps(theta) - eps_0. The polarisation
/// is P_s L(x), L(x) = coth x - 1/x: chi g in weak fields, P_s at most.
class SaturatingDielectric : public Permittivity
{
public:
  static constexpr const char* name = "saturating";
  static constexpr const char* meaning =
      "polarisation with a limit (Langevin), entry `Saturation polarisation`";

  void declare(dealii::ParameterHandler& prm)
  {
    Permittivity::declare(prm);
    add_quantity(prm, "Saturation polarisation", P_s,
                 "P_s, which the polarisation approaches in strong true fields. Default: an "
                 "example, chi g at a true field of 320 kV/mm; take yours from charges measured "
                 "up to such fields.",
                 Quantity("uC/mm^2", 1e-12));
  }

  template <typename Number>
  Number psi(const PointState<Number>& state, const Kinematics<Number>& kin) const
  {
    return -kin.J * Potential<Number>(*this, TrueField<Number>(state, kin).square, state.theta).Phi;
  }

  template <typename Number>
  void add_first(const PointState<Number>& state, const Kinematics<Number>& kin,
                 FirstDerivatives<Number>& out) const
  {
    const TrueField<Number> field(state, kin);
    const Potential<Number> p(*this, field.square, state.theta);
    add_maxwell(field, kin, Number(p.e * kin.J), Number(p.Phi * kin.J), out);
    out.eta += eps.slope(state.theta) * kin.J * p.Phi_chi;
  }

  /// Beside the part at fixed e, psi has -J Phi'' times the square of the change of g.g, which is
  /// 2 d.dE - 2 g.dF d.
  template <typename Number>
  void add_second(const PointState<Number>& state, const Kinematics<Number>& kin,
                  SecondDerivatives<Number>& out) const
  {
    const TrueField<Number> field(state, kin);
    const Potential<Number> p(*this, field.square, state.theta);
    add_maxwell(field, kin, Number(p.e * kin.J), Number(p.Phi * kin.J), out);
    const Tensor3<1, Number>&g = field.g, &d = field.d;
    const Number bend = 2. * p.e_square * kin.J, slope = eps.slope(state.theta),
                 of_e = slope * kin.J * p.e_chi;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J) {
        const Number gd = bend * g[i] * d[J];
        out.dD_dE[i][J] += bend * d[i] * d[J];
        for (unsigned int L = 0; L < 3; ++L) {
          out.dP_dE[i][J][L] += gd * d[L];
          for (unsigned int k = 0; k < 3; ++k)
            out.dP_dF[i][J][k][L] -= gd * g[k] * d[L];
        }
      }
    add_stress(field, kin, of_e, Number(slope * kin.J * p.Phi_chi), out.dP_dtheta);
    out.dD_dtheta += of_e * d;
    out.deta_dtheta +=
        kin.J * (eps.curvature(state.theta) * p.Phi_chi + slope * slope * p.Phi_chichi);
  }

private:
  /// Phi and e = 2 dPhi/d(g.g), with their derivatives, in z = x^2, so that a field of 0 is smooth.
  template <typename Number>
  struct Potential {
    Potential(const SaturatingDielectric& law, const Number& square, const Number& theta)
    {
      const Number chi = law.eps.value(theta) - vacuum_permittivity,
                   scale = chi * 9. / (law.P_s * law.P_s), z = scale * chi * square;
      const LangevinOfSquare<Number> L(z);
      Phi = square / 2. * (vacuum_permittivity + chi * L.mean);
      e = vacuum_permittivity + chi * L.ratio;
      e_square = chi * scale * chi * L.slope;
      Phi_chi = square * (L.ratio - L.mean / 2.);
      e_chi = L.ratio + 2. * z * L.slope;
      Phi_chichi = square * scale * square * (2. * L.slope - L.mean_slope);
    }

    Number Phi, e, e_square, Phi_chi, e_chi, Phi_chichi;
  };

  double P_s = 0.01; ///< uC/mm^2 = N/(kV mm)
};

} // namespace thelma
