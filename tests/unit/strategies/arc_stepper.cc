#include <thelma/strategies/arc_stepper.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{

using namespace thelma;

TEST(ArcStepper, EndsWithoutALength)
{
  ArcStepper stepper;
  stepper.start(std::numeric_limits<double>::quiet_NaN(), 1e-8);
  EXPECT_TRUE(stepper.exhausted());
}

TEST(ArcStepper, GrowsAgainAfterAFailure)
{
  ArcStepper stepper;
  stepper.start(1., 1e-3);
  stepper.cut_back(stepper.step());
  EXPECT_EQ(stepper.step(), 0.5);
  for (int n = 0; n < 10; ++n)
    stepper.accept(3, 0.01, 2.);
  EXPECT_EQ(stepper.step(), 2.);
  for (int n = 0; n < 20; ++n)
    stepper.cut_back(stepper.step());
  EXPECT_TRUE(stepper.exhausted());
}

} // namespace
