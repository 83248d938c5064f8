#include <thelma/base/error.h>
#include <thelma/materials/temperature_table.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace thelma
{
namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Of the line over a width.
struct Secant {
  double width, slope;
};

/// Weighted harmonic mean of the slopes on both sides, which keeps the curve monotone; 0 at an
/// extremum (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300).
double slope_between(const Secant& before, const Secant& after)
{
  if (!(before.slope * after.slope > 0.))
    return 0.;
  const double a = 2. * after.width + before.width, b = after.width + 2. * before.width;
  return (a + b) / (a / before.slope + b / after.slope);
}

/// Of the parabola through three values, within the bounds of monotony.
double slope_at_end(const Secant& outer, const Secant& inner)
{
  const double slope =
      ((2. * outer.width + inner.width) * outer.slope - outer.width * inner.slope) /
      (outer.width + inner.width);
  if (!(slope * outer.slope > 0.))
    return 0.;
  return outer.slope * inner.slope > 0. || std::abs(slope) <= 3. * std::abs(outer.slope)
             ? slope
             : 3. * outer.slope;
}

std::vector<double> slopes(const std::vector<Secant>& secants)
{
  const std::size_t n = secants.size();
  if (n == 1)
    return {secants[0].slope, secants[0].slope};
  std::vector<double> result{slope_at_end(secants[0], secants[1])};
  for (std::size_t k = 1; k < n; ++k)
    result.push_back(slope_between(secants[k - 1], secants[k]));
  result.push_back(slope_at_end(secants[n - 1], secants[n - 2]));
  return result;
}

} // namespace

const TemperatureTable::Cubic<> TemperatureTable::outside{nan, {nan, nan, nan, nan}};

TemperatureTable::TemperatureTable(const std::vector<double>& temperatures,
                                   const std::vector<double>& values)
{
  if (temperatures.size() < 2)
    throw InputError("a table needs values at two temperatures or more, as `273: 1, 293: 2`; write "
                     "a constant without its temperature");
  std::vector<Secant> secants;
  for (std::size_t k = 0; k + 1 < temperatures.size(); ++k) {
    const double width = temperatures[k + 1] - temperatures[k];
    if (!(width > 0.))
      throw InputError("the temperature " + as_text(temperatures[k + 1]) + " K comes after " +
                       as_text(temperatures[k]) + " K; write each one once and in rising order");
    secants.push_back({width, (values[k + 1] - values[k]) / width});
  }
  const std::vector<double> d = slopes(secants);
  for (std::size_t k = 0; k < secants.size(); ++k) {
    const auto [h, secant] = secants[k];
    pieces.push_back({temperatures[k],
                      {values[k], d[k], (3. * secant - 2. * d[k] - d[k + 1]) / h,
                       (d[k] + d[k + 1] - 2. * secant) / (h * h)}});
  }
  end = temperatures.back();
}

void TemperatureTable::scale(const double factor)
{
  for (Cubic<>& piece : pieces)
    for (double& a : piece.a)
      a *= factor;
}

} // namespace thelma
