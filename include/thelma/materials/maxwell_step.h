#pragma once

#include <thelma/materials/point.h>

namespace thelma
{

/// How C_v of a Maxwell branch flows over a step: it ends at N/(det N)^{1/3} with N = start +
/// weight C_iso and the strain C_iso at the end (theory.md, eq. 48).
struct MaxwellStep {
  Tensor3<2> start;
  double weight = 0.;
  double zeta = 0.; ///< integral of s/tau over the step
  double s = 1.;    ///< its mean; s = C_iso : C_v^{-1}/3
};

/// From @p C_v at the strain @p C_iso, which then goes straight; @p x is the length of the step
/// over the relaxation time.
MaxwellStep exponential_step(const Tensor3<2>& C_v, const Tensor3<2>& C_iso, double x);

/// The same by backward Euler.
MaxwellStep first_order_step(const Tensor3<2>& C_v, double x);

/// Where a step ends.
Tensor3<2> end_of(const MaxwellStep& step, const Tensor3<2>& C_iso);

/// How much an exponential step from @p C_v, which has ended at @p C_v_end and the strain @p C_iso,
/// is wrong because the strain did not go straight (@p bend: its second derivative times the square
/// of the length) and tau was not what the step took it for (@p slip: relative error of 1/tau).
double error_of(const MaxwellStep& step, const Tensor3<2>& C_v, const Tensor3<2>& C_iso_start,
                const Tensor3<2>& C_iso, const Tensor3<2>& C_v_end, const Tensor3<2>& bend,
                double slip);

} // namespace thelma
