#pragma once

#include <thelma/base/lanes.h>

#include <cmath>

namespace thelma
{

/// Langevin's function L(x) = coth x - 1/x for x > 0, its slope and ln(sinh x / x), whose slope it
/// is, to rounding: series in x^2 below 1, where the closed forms cancel. Without branches.
template <typename Number>
struct Langevin {
  explicit Langevin(const Number& x)
  {
    using std::exp;
    using std::log;
    const Number y = exp(-2. * x), left = 1. - y, low = series(x);
    value = below(x, 1., low, Number((1. + y) / left - 1. / x));
    slope = below(x, 1., Number(1. - value * (value + 2. / x)),
                  Number(1. / (x * x) - 4. * y / (left * left)));
    log_shc = below(x, 1., log_shc, Number(x + log(left / (2. * x))));
  }

  Number value, slope, log_shc;

private:
  /// Sets ln(sinh x / x) = ln(1 + z) = 2 artanh(z/(2 + z)); returns
  /// (x cosh x - sinh x)/(x sinh x).
  Number series(const Number& x)
  {
    const Number s = x * x;
    Number over = 1., under = 1., sum = 0.;
    for (unsigned int k = 8; k > 0; --k)
      over = 1. + 1. / (2. * k * (2. * k + 3.)) * s * over;
    for (unsigned int k = 8; k > 1; --k)
      under = 1. + 1. / (2. * k * (2. * k + 1.)) * s * under;
    const Number z = s / 6. * under, t = z / (2. + z), t_2 = t * t;
    for (unsigned int k = 9; k > 0; --k)
      sum = 1. / (2. * k - 1.) + t_2 * sum;
    log_shc = 2. * t * sum;
    return x / 3. * over / (1. + z);
  }
};

/// x with L(x) = r for 0 < r < 1, as exactly as r has it; no number from r = 1 on. Kroeger's
/// rational function (J. Non-Newtonian Fluid Mech. 223 (2015) 77), 2e-3 off, and two of Halley's
/// steps, each of which cubes the error. Automatic derivatives converge with the value.
template <typename Number>
Number inverse_langevin(const Number& r)
{
  const Number s = r * r, left = 1. - s;
  Number x = r * (3. - s * (6. + s * (1. - 2. * s)) / 5.) / positive(left);
  for (unsigned int step = 0; step < 2; ++step) {
    const Langevin<Number> L(x);
    const Number error = L.value - r,
                 curvature = 2. * ((L.value / x - L.slope) / x - L.value * L.slope);
    x -= 2. * error * L.slope / (2. * L.slope * L.slope - error * curvature);
  }
  return x;
}

} // namespace thelma
