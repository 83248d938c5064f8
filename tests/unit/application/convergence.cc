// Error estimates from series of runs (theory.md, eqs. 84 and 85): numbers with known limits.

#include <thelma/application/convergence.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace thelma;

/// Values of a number with the limit @p limit and the error @p error(h), h halved each time.
template <typename Error>
std::vector<double> series(const double limit, const Error& error, const unsigned int n)
{
  std::vector<double> values;
  for (unsigned int k = 0; k < n; ++k)
    values.push_back(limit + error(std::exp2(-static_cast<double>(k))));
  return values;
}

/// Estimate over true error.
double effectivity(const std::vector<double>& values, const std::size_t given, const double limit)
{
  return convergence(values, given, 4., 0.).error() / std::abs(values[given] - limit);
}

TEST(Convergence, MeasuresTheOrder)
{
  for (const double order : {0.5, 0.8, 1., 2., 4.})
    for (const unsigned int given : {0u, 1u})
      EXPECT_NEAR(effectivity(series(
                                  3., [&](const double h) { return std::pow(h, order); }, 3),
                              given, 3.),
                  1.25, 1e-10);
}

TEST(Convergence, TwoRunsCoverEveryOrder)
{
  for (const double order : {0.6, 1., 2., 4.}) {
    const double ratio =
        effectivity(series(
                        3., [&](const double h) { return -std::pow(h, order); }, 2),
                    0, 3.);
    EXPECT_GE(ratio, 1.);
    EXPECT_LE(ratio, 3.);
  }
}

TEST(Convergence, OrdersMayMix)
{
  for (const double share : {0.05, 0.3, 1., 3.}) {
    const auto error = [&](const double h) { return share * h + std::pow(h, 4); };
    const double ratio = effectivity(series(0., error, 3), 0, 0.);
    EXPECT_GE(ratio, 1.) << share;
    EXPECT_LE(ratio, 2.) << share;
  }
}

TEST(Convergence, ALogarithmHasNoLimit)
{
  const auto values = series(
      5., [](const double h) { return 0.1 * std::log(h) + 0.01 * h; }, 3);
  EXPECT_FALSE(convergence(values, 0, 4., 1e-9).has_limit);
  EXPECT_TRUE(convergence({1., 1. + 1e-12, 1. + 3e-12}, 0, 4., 1e-9).has_limit) << "round-off";
  EXPECT_TRUE(convergence({1e-17, 3e-17, 9e-17}, 0, 4., 1e-9).has_limit) << "zero";
  EXPECT_TRUE(convergence({0., 0., 0.}, 0, 4., 0.).has_limit);
}

Outcome ended(const double deflection, const double energy, const double unstable = 0.)
{
  Outcome outcome;
  outcome.final_values = {{"step", 7.},
                          {"tip_u1_mm", deflection},
                          {"tip_u3_mm", -1e-12},
                          {"energy_mJ", energy},
                          {"unstable_directions", unstable}};
  return outcome;
}

TEST(Convergence, MirrorImagesAndOtherEndsAreNotCompared)
{
  const Outcome given = ended(0.62, 3.);
  EXPECT_EQ(disagreement(given, ended(0.65, 3.1)), "");
  EXPECT_NE(disagreement(given, ended(-0.64, 3.1)).find("tip_u1_mm"), std::string::npos);
  Outcome opposite_noise = ended(0.62, 3.);
  opposite_noise.final_values[2].second = 1e-12;
  EXPECT_EQ(disagreement(given, opposite_noise), "");
  Outcome pull_in = given;
  pull_in.end(EndReason::pull_in, "");
  pull_in.pull_in = Bracket{0.5, 0.6, 0.55};
  EXPECT_NE(disagreement(given, pull_in).find("pull-in"), std::string::npos);
  EXPECT_EQ(doubt(given, given), "");
  EXPECT_NE(doubt(given, ended(0.62, 3., 2.)).find("2 unstable"), std::string::npos);
}

TEST(Convergence, ABracketIsPartOfTheError)
{
  Outcome outcome = ended(0.62, 3.);
  outcome.ended = EndReason::pull_in;
  outcome.pull_in = Bracket{0.5, 0.6, 0.55};
  const std::vector<Result> found = results(outcome, 1e-10);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].value, 0.55);
  EXPECT_NEAR(found[0].uncertainty, 0.05, 1e-15);
}

} // namespace
