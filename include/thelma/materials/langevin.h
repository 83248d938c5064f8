#pragma once

#include <thelma/base/lanes.h>

#include <array>
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

/// 3 L(x)/x, its mean from 0 to z = x^2, which is 6 ln(sinh x / x)/z, and their slopes as functions
/// of z, smooth at 0: their series below 1. Without branches.
template <typename Number>
class LangevinOfSquare
{
public:
  explicit LangevinOfSquare(const Number& z) : ratio(0.), mean(0.), slope(0.), mean_slope(0.)
  {
    using std::sqrt;
    for (unsigned int k = n; k-- > 0;) {
      const double a = series[k];
      slope = ratio + z * slope;
      mean_slope = mean + z * mean_slope;
      ratio = a + z * ratio;
      mean = a / (k + 1.) + z * mean;
    }
    const Number x = sqrt(z);
    const Langevin<Number> L(x);
    const Number high = 3. * L.value / x, high_mean = 6. * L.log_shc / z;
    slope = below(z, 1., slope, Number(1.5 * (L.slope - L.value / x) / z));
    mean_slope = below(z, 1., mean_slope, Number((high - high_mean) / z));
    ratio = below(z, 1., ratio, high);
    mean = below(z, 1., mean, high_mean);
  }

  Number ratio, mean, slope, mean_slope;

private:
  static constexpr unsigned int n = 18; ///< z^k is multiplied by 1/pi^(2k), as far as rounding

  /// Coefficients of the ratio A, for which L' = 1 - L^2 - 2 L/x is A + 2/3 z A' = 1 - z A^2/9.
  static constexpr std::array<double, n> coefficients()
  {
    std::array<double, n> a{{1.}};
    for (unsigned int k = 1; k < n; ++k) {
      double square = 0.;
      for (unsigned int i = 0; i < k; ++i)
        square += a[i] * a[k - 1 - i];
      a[k] = -square / (9. + 6. * k);
    }
    return a;
  }

  static constexpr std::array<double, n> series = coefficients();
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
