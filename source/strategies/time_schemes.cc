#include <thelma/strategies/time_schemes.h>

#include <algorithm>
#include <cmath>

namespace thelma
{
namespace
{

Rates bdf2(const double time, const std::vector<double>& times)
{
  return backward_differences(time, times, 2);
}

Rates backward_euler(const double time, const std::vector<double>& times)
{
  return backward_differences(time, times, 1);
}

} // namespace

const std::vector<TimeScheme>& time_schemes()
{
  static const std::vector<TimeScheme> list{
      {"BDF2",
       "second order: backward differences of the temperature, begun with one step of the "
       "first, and exponential steps of viscoelastic branches",
       2, bdf2},
      {"backward Euler", "first order", 1, backward_euler}};
  return list;
}

const TimeScheme& time_scheme(const std::string& name)
{
  return *std::find_if(time_schemes().begin(), time_schemes().end(),
                       [&](const TimeScheme& scheme) { return scheme.name == name; });
}

/// Both errors are multiples of the derivative of the order after the last that is exact.
double error_share(const TimeScheme& scheme, const double time, const std::vector<double>& times,
                   const unsigned int order)
{
  const auto newest = times.end() - (order < scheme.order ? order : times.size());
  const Rates rates = scheme.rates(time, {newest, times.end()});
  const auto before = [&](const std::size_t k) { return time - times[times.size() - k]; };
  double step = 0., extrapolation = 1.;
  for (std::size_t k = 1; k <= rates.n_past; ++k)
    step -= rates.weights[k] / rates.weights[0] * std::pow(-before(k), order + 1);
  for (std::size_t k = 1; k <= order + 1; ++k)
    extrapolation *= before(k);
  return std::abs(step) / (std::abs(step) + extrapolation);
}

} // namespace thelma
