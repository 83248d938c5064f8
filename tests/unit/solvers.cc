// The steppers and Newton's method on systems whose answers are known by hand.

#include <thelma/solvers/continuation.h>
#include <thelma/solvers/newton.h>
#include <thelma/strategies/load_stepper.h>
#include <thelma/strategies/time_stepper.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

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

/// exp(x) = 1 + load, with det F = 1 - x so that large steps are forbidden.
struct Exponential : NonlinearSystem {
  ResidualReport residual() override { return {std::abs(std::exp(x) - target) + noise, 1. - x}; }
  LinearReport linear_solve(const bool reuse) override
  {
    base = x;
    if (!reuse)
      slope = std::exp(x);
    correction = -(std::exp(x) - target) / slope;
    return {true, "", !reuse, 3, 5.};
  }
  void move_to(const double step) override { x = base + step * correction; }
  double rounding() override { return noise; }

  double noise = 0., x = 0., target = 2., base = 0., slope = 0., correction = 0.;
};

TEST(Newton, ConvergesQuadraticallyToTheLogarithm)
{
  Exponential system;
  Newton newton;
  dealii::ParameterHandler prm;
  newton.declare(prm);
  prm.parse_input_from_string("subsection Newton\n set Reuse tangent = false\nend\n");
  const NewtonReport report = newton.solve(system);
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR(system.x, std::log(2.), 1e-10);
  EXPECT_EQ(report.negative_pivots, 3);
  const std::vector<double>& r = report.residuals;
  ASSERT_GE(r.size(), 4u);
  EXPECT_GT(std::log(r[3] / r[2]) / std::log(r[2] / r[1]), 1.8);
}

TEST(Newton, EndsWhereTheResidualIsMadeOfRounding)
{
  Exponential system;
  system.noise = 1e-9; // ten times the tolerance
  const NewtonReport report = Newton().solve(system);
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR(system.x, std::log(2.), 1e-10);
  EXPECT_EQ(report.rounding, system.noise);
  system = {};
  system.noise = 1e-5; // too much to be anything
  EXPECT_FALSE(Newton().solve(system).converged);
}

/// exp(x) = 1 + a, where a is to be x at the solution, from above 1/2.
struct Following : Exponential {
  void begin() override { target = 1. + std::max(x, 0.5); }
  bool follow() override
  {
    const double before = target;
    begin();
    return target != before;
  }
};

TEST(Newton, LetsTheSystemFollowItsSolution)
{
  Following system;
  const NewtonReport report = Newton().solve(system);
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR(system.x, std::log(1.5), 1e-10); // below 1/2
  system.x = 0.6;
  EXPECT_TRUE(Newton().solve(system).converged);
  EXPECT_NEAR(system.x, std::log(1.5), 1e-10);
}

TEST(Newton, ReusesATangentThatServesWell)
{
  Exponential system;
  system.x = std::log(2.) + 1e-3;
  const NewtonReport report = Newton().solve(system);
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR(system.x, std::log(2.), 1e-10);
  EXPECT_EQ(report.factorisations, 1u);
  EXPECT_GT(report.iterations, 1u);
}

TEST(Newton, CountsNoIterationThatRoundingDecidesOn)
{
  NewtonReport report;
  for (const double last : {0.9e-10, 1.1e-10}) {
    report.residuals = {1., 1e-3, last};
    EXPECT_EQ(Newton().telling_iterations(report), 2u);
    report.residuals.push_back(1e-13);
    EXPECT_EQ(Newton().telling_iterations(report), 2u);
  }
  report.residuals = {1., 1e-3, 1e-6, 1e-12};
  EXPECT_EQ(Newton().telling_iterations(report), 3u);
}

TEST(Newton, KeepsTheDeterminantPositive)
{
  Exponential system;
  system.x = -2.; // the full step would go to x = 11.8
  const NewtonReport report = Newton().solve(system);
  EXPECT_TRUE(report.converged) << report.reason;
  EXPECT_NEAR(system.x, std::log(2.), 1e-10);
}

TEST(Newton, RefinesAStateUntilRounding)
{
  Exponential system;
  const Newton newton;
  system.x = std::log(2.) + 1e-6;
  EXPECT_TRUE(newton.solve(system).converged);
  EXPECT_EQ(newton.refine(system, 1.).iterations, 0u);
  EXPECT_GT(newton.refine(system, 0.).iterations, 0u);
  EXPECT_NEAR(system.x, std::log(2.), 1e-15);
}

TEST(Newton, FailsAsAValue)
{
  Exponential system;
  system.target = -1.;
  const NewtonReport report = Newton().solve(system);
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());
}

/// u^3 - u = load, with limit points at u = +- 1/sqrt(3).
struct Cubic : LoadedSystem {
  Cubic() : u(1), du(1), du_dload(1) {}
  double load() const override { return factor; }
  void set_load(const double load) override { factor = load; }
  const Displacement& displacement() const override { return u; }
  const Displacement& correction() const override { return du; }
  const Displacement& response() const override { return du_dload; }
  double excess() const { return u(0) * u(0) * u(0) - u(0) - factor; }
  double slope() const { return 3. * u(0) * u(0) - 1.; }
  ResidualReport residual() override { return {std::abs(excess()), 1.}; }
  LinearReport linear_solve(bool) override
  {
    base = u(0);
    du(0) = -excess() / slope();
    return {true, "", true};
  }
  LinearReport solve_load() override
  {
    du_dload(0) = 1. / slope();
    return {true, ""};
  }
  void add_response(const double change) override { du(0) += change * du_dload(0); }
  double rounding() override { return 0.; }
  void move_to(const double step) override { u(0) = base + step * du(0); }

  Displacement u, du, du_dload;
  double factor = 0., base = 0.;
};

TEST(BorderedSystem, FindsStatesBeyondALimitPointAndNextToIt)
{
  const double limit = -1. / std::sqrt(3.);
  for (const double target : {-0.2, limit + 1e-7, 0.4}) {
    Cubic system;
    system.u(0) = -1.;
    Plane plane;
    plane.normal = system.u;
    plane.normal(0) = 1.;
    plane.value = target;
    BorderedSystem bordered(system, plane);
    const NewtonReport report = Newton().solve(bordered);
    EXPECT_TRUE(report.converged) << report.reason;
    EXPECT_NEAR(system.u(0), target, 1e-9);
    EXPECT_NEAR(system.load(), target * target * target - target, 1e-9);
  }
}

TEST(BorderedSystem, TellsThatTheLoadHasNoResponse)
{
  struct Unsolvable : Cubic {
    LinearReport solve_load() override { return {false, "the reason"}; }
  } system;
  Plane plane;
  plane.normal = system.u;
  BorderedSystem bordered(system, plane);
  const NewtonReport report = Newton().solve(bordered);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.reason, "the reason");
}

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

/// Steps of one length are that long again after one that had to be cut, and meet the stops.
TEST(TimeStepper, ReturnsToItsLengthAfterACut)
{
  dealii::ParameterHandler prm;
  TimeStepper stepper;
  stepper.declare(prm);
  prm.parse_input_from_string("subsection Time\nset End = 10\nset Initial step = 1\n"
                              "set Tolerance = 0\nset Stops = 0.5, 4.25\nend\n");
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
  stepper.start({}, {});
  const auto result = [](const double t) { return 1. / (1. + t); };
  double taken = stepper.next(), estimate = 0.;
  std::optional<StepError> error;
  while (!stepper.accept(error)) {
    const double longer = std::exchange(taken, stepper.next());
    const double line = 1. + longer / taken * (result(taken) - 1.);
    estimate = first_error_share(taken, longer) * (result(longer) - line);
    error = StepError{estimate, 1};
  }
  EXPECT_LE(estimate, tolerance);
  EXPECT_GT(estimate, tolerance / 100.);
  EXPECT_NEAR(estimate, result(taken) - std::exp(-taken), 0.05 * estimate);
}

} // namespace
