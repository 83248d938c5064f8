#pragma once

#include <thelma/materials/point.h>
#include <thelma/materials/temperature_law.h>

namespace thelma
{

/// Ideal dielectric (theory.md, eq. 10), with the true field g = F^{-T} E and d = F^{-1} g:
///   psi = -eps/2 J C^{-1} : E x E = -eps/2 J g.g,   D = eps J d,
///   P = eps J (g x d - g.g/2 F^{-T}).
class IdealDielectric
{
public:
  static constexpr const char* name = "ideal";
  static constexpr const char* meaning = "permittivity independent of deformation";

  void declare(dealii::ParameterHandler& prm)
  {
    eps.declare(prm, "Permittivity", "eps(theta).", Quantity("N/kV^2"));
  }

  /// Permittivity of the undeformed material in N/kV^2.
  double permittivity(const double theta) const { return eps.value(theta); }

  template <typename Number>
  Number psi(const PointState<Number>& state, const Kinematics<Number>& kin) const
  {
    const Tensor3<1, Number> g = kin.G * state.E;
    return -eps.value(state.theta) / 2. * kin.J * (g * g);
  }

  template <typename Number>
  void add_first(const PointState<Number>& state, const Kinematics<Number>& kin,
                 FirstDerivatives<Number>& out) const
  {
    const Tensor3<1, Number> g = kin.G * state.E, d = g * kin.G;
    const Number gg = g * g, eps_J = eps.value(state.theta) * kin.J;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        out.P[i][J] += eps_J * (g[i] * d[J] - gg / 2. * kin.G[i][J]);
    out.D += eps_J * d;
    out.eta += eps.slope(state.theta) * kin.J * gg / 2.;
  }

  template <typename Number>
  void add_second(const PointState<Number>& state, const Kinematics<Number>& kin,
                  SecondDerivatives<Number>& out) const
  {
    const Tensor3<2, Number>& G = kin.G;
    const Tensor3<1, Number> g = G * state.E, d = g * G;
    const Tensor3<2, Number> C_inv = dealii::transpose(G) * G;
    const Number gg = g * g;
    const Number eps_J = eps.value(state.theta) * kin.J;
    const Number slope_J = eps.slope(state.theta) * kin.J;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J) {
        const Number stress = g[i] * d[J] - gg / 2. * G[i][J];
        out.dP_dtheta[i][J] += slope_J * stress;
        out.dD_dE[i][J] += eps_J * C_inv[i][J];
        for (unsigned int L = 0; L < 3; ++L) {
          out.dP_dE[i][J][L] += eps_J * (G[i][L] * d[J] + g[i] * C_inv[J][L] - d[L] * G[i][J]);
          for (unsigned int k = 0; k < 3; ++k)
            out.dP_dF[i][J][k][L] += eps_J * (G[k][L] * stress - G[i][L] * g[k] * d[J] -
                                              g[i] * (d[L] * G[k][J] + C_inv[J][L] * g[k]) +
                                              d[L] * g[k] * G[i][J] + gg / 2. * G[i][L] * G[k][J]);
        }
      }
    out.dD_dtheta += slope_J * d;
    out.deta_dtheta += eps.curvature(state.theta) * kin.J * gg / 2.;
  }

private:
  TemperatureLaw eps{{3.98e-5}};
};

} // namespace thelma
