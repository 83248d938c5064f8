// Steps towards a target over paths that end where a formula says.

#include <thelma/strategies/load_stepper.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{

using namespace thelma;

constexpr double far_away = std::numeric_limits<double>::infinity();

/// Drives a stepper over a path that exists up to @p limit.
LoadStepper run_to(const double limit, const double resolution)
{
  LoadStepper stepper;
  stepper.start(resolution, 0.1);
  while (!stepper.finished() && !stepper.exhausted()) {
    if (stepper.next() <= limit)
      stepper.accept(4, limit);
    else
      stepper.cut_back();
  }
  return stepper;
}

TEST(LoadStepper, ReachesTheTargetExactly)
{
  const LoadStepper stepper = run_to(2., 1e-4);
  EXPECT_TRUE(stepper.finished());
  EXPECT_EQ(stepper.accepted(), 1.);
}

TEST(LoadStepper, BracketsALimit)
{
  const double limit = 0.6873653;
  const LoadStepper stepper = run_to(limit, 1e-4);
  EXPECT_TRUE(stepper.exhausted());
  EXPECT_LE(stepper.accepted(), limit);
  EXPECT_GT(stepper.failed(), limit);
  EXPECT_LE(stepper.failed() - stepper.accepted(), 1e-4);
}

TEST(LoadStepper, ForgetsAFailureThatThePathContradicts)
{
  LoadStepper stepper;
  stepper.start(1e-4, 0.2);
  stepper.next();
  stepper.cut_back();
  EXPECT_EQ(stepper.next(), 0.1);
  stepper.accept(2, far_away);
  EXPECT_GT(stepper.failed(), 1.);
}

TEST(LoadStepper, GrowsFromTheStepThatWasTaken)
{
  LoadStepper stepper;
  stepper.start(1e-4, 0.1);
  stepper.next();
  stepper.accept(1, 0.101); // a limit is announced, and does not come
  const double before = stepper.next() - stepper.accepted();
  EXPECT_LT(before, 1e-3);
  stepper.accept(1, far_away);
  EXPECT_NEAR(stepper.next() - stepper.accepted(), 3. * before, 1e-12);
}

TEST(LoadStepper, ComesNearerToWhereAnotherPathWasFound)
{
  LoadStepper stepper;
  stepper.start(1e-4, 0.1);
  while (!stepper.exhausted()) {
    if (stepper.next() <= 0.5)
      stepper.accept(4, 0.5);
    else
      stepper.cut_back(true);
  }
  EXPECT_LE(stepper.failed() - stepper.accepted(), 1e-7);
}

} // namespace
