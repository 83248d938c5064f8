// Where time steps must not step over an amplitude.

#include <thelma/base/error.h>
#include <thelma/loads/amplitude.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace thelma;

namespace
{

AmplitudeTimes times(const std::string& text, const double end)
{
  return Amplitude("here", text).times(end);
}

TEST(Amplitude, OfOneLineHasNothingToMeet)
{
  for (const char* text : {"1", "0.3*pi", "t", "2 - 3*t"}) {
    EXPECT_TRUE(times(text, 7.).kinks.empty()) << text;
    EXPECT_TRUE(times(text, 7.).bends.empty()) << text;
  }
}

/// A choice `a ? b : c` is no table.
TEST(Amplitude, JumpsAreMetJustBefore)
{
  for (const char* text : {"(t > 50) * (t < 51)", "t > 50 ? (t < 51 ? 1 : 0) : 0"}) {
    const std::vector<double> kinks = times(text, 100.).kinks;
    ASSERT_EQ(kinks.size(), 2u) << text;
    EXPECT_NEAR(kinks[0], 50., 1e-12);
    EXPECT_NEAR(kinks[1], 51., 1e-12);
    const Amplitude amplitude("here", text);
    EXPECT_EQ(amplitude(kinks[0]), 0.);
    EXPECT_EQ(amplitude(kinks[1]), 1.);
  }
}

/// A millionth of the time.
TEST(Amplitude, ShortPulsesAreSeenByTheirNumbers)
{
  EXPECT_EQ(times("(t > 500) * (t < 500.01)", 10000.).kinks.size(), 2u);
}

TEST(Amplitude, KinksAreMet)
{
  const auto meets = [](const std::string& text, const double end, const double time) {
    for (const double kink : times(text, end).kinks)
      if (std::abs(kink - time) < 1e-9 * end)
        return true;
    return false;
  };
  EXPECT_TRUE(meets("min(t, 1)", 2., 1.));
  EXPECT_TRUE(meets("abs(t - 1/3)", 2., 1. / 3.));
  EXPECT_TRUE(meets("abs(sin(t))", 4., std::acos(-1.)));
}

/// A line stays within 0.04, 2 % of the range, of a wave of amplitude 1 for 0.57 to 1.1 radians
/// where that is most curved, and longer elsewhere.
TEST(Amplitude, WavesAreCutIntoStraightPieces)
{
  const std::vector<double> bends = times("sin(2*pi*10*t)", 3.).bends;
  EXPECT_GT(bends.size(), 30u * 5u);
  EXPECT_LT(bends.size(), 30u * 12u);
  EXPECT_TRUE(std::is_sorted(bends.begin(), bends.end()));
  const Amplitude amplitude("here", "sin(2*pi*10*t)");
  for (std::size_t i = 1; i < bends.size(); ++i)
    for (const double part : {0.25, 0.5, 0.75}) {
      const double a = bends[i - 1], b = bends[i];
      const double line = (1. - part) * amplitude(a) + part * amplitude(b);
      EXPECT_LT(std::abs(amplitude((1. - part) * a + part * b) - line), 2. * 0.04);
    }
}

TEST(Amplitude, MustBeFiniteAllTheTime)
{
  EXPECT_THROW(times("1/t", 1.), InputError);
  EXPECT_THROW(times("1/(t - 0.5)", 1.), InputError);
}

} // namespace
