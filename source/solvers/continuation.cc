#include <thelma/solvers/continuation.h>

#include <cmath>

namespace thelma
{

double PathMetric::length(const Displacement& u, const double load) const
{
  return chosen ? std::abs(*chosen * u) : std::sqrt(weight * u.norm_sqr() + load * load);
}

Plane PathMetric::across(const Displacement& u, const double load) const
{
  const double size = length(u, load);
  Plane plane;
  plane.normal = chosen ? *chosen : u;
  plane.normal *= (chosen ? *chosen * u : weight) / size;
  plane.normal.zero_out_ghost_values();
  plane.load_normal = chosen ? 0. : load / size;
  return plane;
}

ResidualReport BorderedSystem::residual()
{
  ResidualReport report = system.residual();
  report.include(std::abs(plane.excess(system)));
  return report;
}

/// Always a fresh tangent, and none to be reused: where directions have lost their stiffness an old
/// one lets rounding grow.
LinearReport BorderedSystem::linear_solve(bool)
{
  base_load = system.load();
  LinearReport report = system.linear_solve(false);
  report.cost = 0.;
  if (!report.solved)
    return report;
  const LinearReport response = system.solve_load();
  report.iterations += response.iterations;
  if (!response.solved) {
    report.solved = false;
    report.reason = response.reason;
    return report;
  }
  load_change = -(plane.excess(system) + plane.normal * system.correction()) /
                (plane.load_normal + plane.normal * system.response());
  system.add_response(load_change);
  return report;
}

void BorderedSystem::move_to(const double step)
{
  system.move_to(step);
  system.set_load(base_load + step * load_change);
}

} // namespace thelma
