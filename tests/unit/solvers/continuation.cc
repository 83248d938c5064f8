// The bordered system beyond limit points of a cubic, and steps along an arc.

#include <thelma/solvers/continuation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace thelma;

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

} // namespace
