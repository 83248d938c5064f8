// Time steps: their stops, and the error of backward Euler that they are to keep.

#include <thelma/strategies/time_stepper.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace
{

using namespace thelma;

/// Steps of one length are that long again after one that had to be cut, and meet the stops.
TEST(TimeStepper, ReturnsToItsLengthAfterACut)
{
  dealii::ParameterHandler prm;
  TimeStepper stepper;
  stepper.declare(prm);
  prm.parse_input_from_string("subsection Time\nset End = 10\nset Initial step = 1\n"
                              "set Tolerance = 0\nset Stops = 0.5, 4.25\nend\n");
  stepper.control(true, false);
  stepper.start({}, {});
  EXPECT_EQ(stepper.next(), 0.5);
  stepper.cut_back();
  std::vector<double> times;
  while (!stepper.finished()) {
    times.push_back(stepper.next());
    stepper.accept({});
  }
  EXPECT_EQ(times.front(), 0.125);
  for (const double stop : {0.5, 4.25, 10.})
    EXPECT_EQ(std::count(times.begin(), times.end(), stop), 1) << stop;
  EXPECT_LT(times.size(), 16u);
  EXPECT_EQ(stepper.step(), 1.);
}

/// Decay, x' = -x, x(0) = 1, by backward Euler, x(t) = 1/(1 + t): the first step is cut until its
/// error is tolerable, and the estimate is that error.
TEST(TimeStepper, JudgesTheFirstStep)
{
  const double tolerance = 1e-5;
  dealii::ParameterHandler prm;
  TimeStepper stepper;
  stepper.declare(prm);
  prm.parse_input_from_string("subsection Time\nset End = 10\nset Initial step = 1\n"
                              "set Tolerance = 1e-5\nend\n");
  stepper.control(true, false);
  stepper.start({}, {});
  const auto result = [](const double t) { return 1. / (1. + t); };
  double taken = stepper.next(), estimate = 0.;
  std::optional<StepError> error;
  while (!stepper.accept(error)) {
    const double longer = std::exchange(taken, stepper.next());
    const double line = 1. + longer / taken * (result(taken) - 1.);
    estimate = first_error_share(taken, longer) * (result(longer) - line);
    error = stepper.of_temperature(StepError{estimate, 1});
  }
  EXPECT_LE(estimate, tolerance);
  EXPECT_GT(estimate, tolerance / 100.);
  EXPECT_NEAR(estimate, result(taken) - std::exp(-taken), 0.05 * estimate);
}

} // namespace
