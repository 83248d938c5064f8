// Newton's method on a scalar equation whose solution is known.

#include <thelma/solvers/newton.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace thelma;

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

} // namespace
