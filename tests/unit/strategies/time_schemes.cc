// Every scheme: what its weights are exact for, and the share of a step's error that follows.

#include <thelma/strategies/time_schemes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace thelma;

const std::vector<double> times{0.1, 0.4, 0.9};
constexpr double now = 1.2;

double rate(const Rates& rates, const unsigned int power)
{
  return rates.of(std::pow(now, power), [&](const std::size_t k) {
    return std::pow(times[times.size() - 1 - k], power);
  });
}

TEST(TimeSchemes, AreExactToTheirOrder)
{
  for (const TimeScheme& scheme : time_schemes()) {
    const Rates rates = scheme.rates(now, times);
    for (unsigned int power = 0; power <= scheme.order; ++power)
      EXPECT_NEAR(rate(rates, power), power * std::pow(now, power - 1.), 1e-13) << scheme.name;
    EXPECT_GT(
        std::abs(rate(rates, scheme.order + 1) - (scheme.order + 1) * std::pow(now, scheme.order)),
        1e-2)
        << scheme.name;
  }
}

/// The value of x = t^(order + 1) now if x' there is exact, as is all before.
double step(const TimeScheme& scheme)
{
  const unsigned int power = scheme.order + 1;
  const Rates rates = scheme.rates(now, times);
  const double exact = std::pow(now, power);
  return exact + (power * std::pow(now, power - 1.) - rate(rates, power)) / rates.weights[0];
}

/// The polynomial misses t^(order + 1) by the product of the distances.
TEST(TimeSchemes, KnowTheShareOfTheError)
{
  for (const TimeScheme& scheme : time_schemes()) {
    const double exact = std::pow(now, scheme.order + 1);
    double missed = 1.;
    for (unsigned int k = 0; k <= scheme.order; ++k)
      missed *= now - times[times.size() - 1 - k];
    EXPECT_NEAR(error_share(scheme, now, times, scheme.order) *
                    std::abs(step(scheme) - exact + missed),
                std::abs(step(scheme) - exact), 1e-13)
        << scheme.name;
  }
}

/// As a step of the order that so few states allow.
TEST(TimeSchemes, BeginWithALowerOrder)
{
  EXPECT_NEAR(error_share(time_scheme("BDF2"), now, {0.4, 0.9}, 1), 0.3 / (0.3 + 0.8), 1e-14);
}

} // namespace
