#pragma once

#include <thelma/materials/point.h>
#include <thelma/materials/sacado_tensors.h>

namespace thelma
{

/// A number with its derivative along the motion of a point.
using Directional = Sacado::Fad::SFad<double, 1>;

inline Directional moving(const double value, const double rate)
{
  Directional x(1, 0, value);
  x.fastAccessDx(0) = rate;
  return x;
}

/// The state while it moves with @p rates at constant temperature.
inline PointState<Directional> along(const PointState<>& state, const PointRates& rates)
{
  PointState<Directional> result;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int J = 0; J < 3; ++J)
      result.F[i][J] = moving(state.F[i][J], rates.F[i][J]);
    result.E[i] = moving(state.E[i], rates.E[i]);
  }
  result.theta = moving(state.theta, 0.);
  result.history = state.history;
  return result;
}

/// Since deta/dF = -dP/dtheta and deta/dE = dD/dtheta, everything about the rate of entropy is in
/// the second derivatives @p d of the energy and in their change along the motion.
inline void add_entropy_rate(const SecondDerivatives<Directional>& d, const PointRates& rates,
                             EntropyRate& out)
{
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int J = 0; J < 3; ++J) {
      out.h -= d.dP_dtheta[i][J].val() * rates.F[i][J];
      out.d_dFdot[i][J] -= d.dP_dtheta[i][J].val();
      out.d_dF[i][J] -= d.dP_dtheta[i][J].dx(0);
    }
    out.h += d.dD_dtheta[i].val() * rates.E[i];
    out.d_dEdot[i] += d.dD_dtheta[i].val();
    out.d_dE[i] += d.dD_dtheta[i].dx(0);
  }
  out.d_dtheta += d.deta_dtheta.dx(0);
}

} // namespace thelma
