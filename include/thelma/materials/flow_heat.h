#pragma once

#include <thelma/materials/point.h>
#include <thelma/materials/sacado_tensors.h>

namespace thelma
{

/// What flow dissipates over a step, per reference volume (theory.md, eq. 52).
template <typename Number = double>
struct Dissipated {
  Number energy = 0.;  ///< MPa
  Number entropy = 0.; ///< the same over the temperature, MPa/K
};

/// Entropy in MPa/K at the end of a step over which internal variables flow, the energy in MPa that
/// the step dissipates, and their derivatives with what the flow makes of the internal variables.
struct FlowHeat {
  double eta = 0., dissipated = 0.;
  Tensor3<2> deta_dF, dD_dF;
  double deta_dtheta = 0., dD_dtheta = 0.;
};

/// A number with its derivatives by F, row by row, and theta.
using OfStrain = Sacado::Fad::SFad<double, 10>;

/// The state with these variables.
inline PointState<OfStrain> of_strain(const PointState<>& state)
{
  PointState<OfStrain> result;
  for (int i = 0; i < 3; ++i) {
    for (int J = 0; J < 3; ++J)
      result.F[i][J] = OfStrain(10, 3 * i + J, state.F[i][J]);
    result.E[i] = state.E[i];
  }
  result.theta = OfStrain(10, 9, state.theta);
  result.history = state.history;
  return result;
}

inline FlowHeat flow_heat(const OfStrain& eta, const OfStrain& dissipated)
{
  FlowHeat heat;
  heat.eta = eta.val();
  heat.dissipated = dissipated.val();
  for (int i = 0; i < 3; ++i)
    for (int J = 0; J < 3; ++J) {
      heat.deta_dF[i][J] = eta.dx(3 * i + J);
      heat.dD_dF[i][J] = dissipated.dx(3 * i + J);
    }
  heat.deta_dtheta = eta.dx(9);
  heat.dD_dtheta = dissipated.dx(9);
  return heat;
}

} // namespace thelma
