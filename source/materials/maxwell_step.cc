#include <thelma/materials/maxwell_step.h>

#include <algorithm>
#include <cmath>

namespace thelma
{
namespace
{

/// At least 1, but for rounding: both have determinant 1.
double flow_factor(const Tensor3<2>& C_iso, const Tensor3<2>& C_v)
{
  return std::max(1., contract(Kinematics<>(C_v).G, C_iso) / 3.);
}

Tensor3<2> normalised(const Tensor3<2>& N)
{
  return N / std::cbrt(dealii::determinant(N));
}

/// Integrals over sigma from 0 to zeta of exp(sigma - zeta) times 1, 1 - sigma/zeta and sigma/zeta.
struct Weights {
  explicit Weights(const double zeta)
  {
    constexpr double small = 1e-3;
    const double decay = std::exp(-zeta);
    all = -std::expm1(-zeta);
    of_end = zeta < small ? zeta * (1. / 2. - zeta * (1. / 6. - zeta / 24.)) : 1. - all / zeta;
    of_start = zeta < small ? zeta * (1. / 2. - zeta * (1. / 3. - zeta / 8.)) : all / zeta - decay;
  }

  double all, of_start, of_end;
};

/// What a unit of the bend adds to C_v: half the integral of exp(sigma - zeta) (sigma/zeta)
/// (1 - sigma/zeta).
double bend_weight(const double zeta)
{
  constexpr double small = 1e-2;
  return zeta < small ? zeta / 12.
                      : (zeta - 2. + (zeta + 2.) * std::exp(-zeta)) / (2. * zeta * zeta);
}

} // namespace

MaxwellStep exponential_step(const Tensor3<2>& C_v, const Tensor3<2>& C_iso, const double x)
{
  constexpr unsigned int passes = 2;
  const double s = flow_factor(C_iso, C_v);
  MaxwellStep step;
  step.s = s;
  for (unsigned int pass = 0; pass < passes; ++pass) { // at a strain that is kept
    const double zeta = x * step.s;
    const Tensor3<2> end = normalised(std::exp(-zeta) * C_v + Weights(zeta).all / step.s * C_iso);
    step.s = (s + flow_factor(C_iso, end)) / 2.;
  }
  step.zeta = x * step.s;
  const Weights weights(step.zeta);
  step.start = std::exp(-step.zeta) * C_v + weights.of_start / step.s * C_iso;
  step.weight = weights.of_end / step.s;
  return step;
}

MaxwellStep first_order_step(const Tensor3<2>& C_v, const double x)
{
  MaxwellStep step;
  step.weight = x / (1. + x);
  step.start = 1. / (1. + x) * C_v;
  step.zeta = x;
  return step;
}

Tensor3<2> end_of(const MaxwellStep& step, const Tensor3<2>& C_iso)
{
  return normalised(step.start + step.weight * C_iso);
}

/// The ratio of the weights of C_iso and C_v changes by zeta/(1 - exp(-zeta)) times a relative
/// error of 1/tau, by 1 less times one of s.
double error_of(const MaxwellStep& step, const Tensor3<2>& C_v, const Tensor3<2>& C_iso_start,
                const Tensor3<2>& C_iso, const Tensor3<2>& C_v_end, const Tensor3<2>& bend,
                const double slip)
{
  const double of_bend = bend_weight(step.zeta) / step.s * bend.norm();
  if (!(step.zeta > 0.))
    return of_bend;
  const double s = (flow_factor(C_iso_start, C_v) + flow_factor(C_iso, C_v_end)) / 2.,
               all = Weights(step.zeta).all, rate = step.zeta / all;
  const double ratio = std::abs(rate * slip) + std::abs((rate - 1.) * (s / step.s - 1.));
  const double old = std::exp(-step.zeta), now = all / step.s;
  return of_bend + ratio * old * now / std::pow(old + now, 2) * (C_iso - C_v).norm();
}

} // namespace thelma
