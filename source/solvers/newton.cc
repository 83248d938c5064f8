#include <thelma/base/parameters.h>
#include <thelma/solvers/newton.h>

#include <algorithm>
#include <cmath>

namespace thelma
{
namespace
{

/// At an iterate whose @p residual is not admissible; @p where: which one that is.
NewtonReport without_residual(const NonlinearSystem& system, const ResidualReport& residual,
                              const std::string& where, NewtonReport report)
{
  if (residual.min_det_F > 0.)
    report.reason = system.law_defect();
  if (report.reason.empty())
    report.reason = residual.defect() + where;
  else
    report.refusal = Refusal::no_law;
  return report;
}

} // namespace

void Newton::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Newton"});
  prm.add_parameter("Tolerance", tolerance,
                    "Scaled residual at which a step has converged; dimensionless: residual "
                    "stress over shear modulus. Where rounding makes more of it, that ends a step.",
                    Double(1e-14, 1e-6)); // a coarser state tells nothing of its stability
  prm.add_parameter("Reuse tangent", reuses,
                    "Whether a factorised tangent serves for further iterations while that is "
                    "cheaper than a new one.",
                    Bool());
  prm.add_parameter("Iterations", max_iterations,
                    "After so many iterations a load step counts as failed and is cut.",
                    Integer(1, 1000));
}

/// The first correction by a new tangent does not tell how well it will serve the next. Near the
/// solution that is tried once, if factorising is expensive; farther off an old tangent may lead
/// astray in soft directions, which the residual shows late: it falls by turns in stiff and in soft
/// ones, so that two corrections tell its rate.
bool Newton::worth_reusing(const NewtonReport& report, const LinearReport& linear) const
{
  constexpr double steady = 0.5, near = 3e-4, expensive = 2.5, most = 5.; // corrections
  if (!reuses)
    return false;
  const auto r = report.residuals.rbegin();
  const bool tries = r[0] < near && report.factorisations <= 1 && linear.cost > expensive;
  if (tries && linear.factorised)
    return true;
  const double rate = tries && report.residuals.size() > 2 ? std::sqrt(r[0] / r[2]) : r[0] / r[1];
  return rate < steady &&
         std::log(r[0] / tolerance) < std::min(linear.cost, most) * std::log(1. / rate);
}

/// Of residuals before and after a correction by a fresh tangent.
bool Newton::is_rounding(NonlinearSystem& system, NewtonReport& report) const
{
  constexpr double steady = 0.5, coarsest = 1e-6, slack = 4.;
  const auto r = report.residuals.rbegin();
  if (r[0] > coarsest || r[0] < steady * r[1])
    return false;
  report.rounding = system.rounding();
  return r[0] <= slack * report.rounding;
}

NewtonReport Newton::solve(NonlinearSystem& system, const bool reuse) const
{
  constexpr unsigned int most = 12;
  constexpr double settled = 1e-7; // residual that the system's change makes: no other state
  system.begin();
  NewtonReport report = iterate(system, reuse);
  double change = 1.;
  for (unsigned int k = 0; k < most && change > settled && report.converged && system.follow();
       ++k) {
    change = system.residual().norm;
    if (change > tolerance)
      report.go_on(iterate(system, true));
  }
  return report;
}

NewtonReport Newton::iterate(NonlinearSystem& system, bool reuse) const
{
  constexpr double smallest_step = 1. / 256., divergence = 1e8;
  NewtonReport report;
  const auto fail = [&](const std::string& reason) {
    report.reason = reason;
    return report;
  };

  ResidualReport residual = system.residual();
  report.residuals.push_back(residual.norm);
  report.min_det_F = residual.min_det_F;
  if (!residual.admissible())
    return without_residual(system, residual, " at the predicted state", report);

  while (!report.converged) {
    if (report.iterations == max_iterations)
      return fail("no convergence in " + std::to_string(max_iterations) + " iterations");
    const LinearReport linear = system.linear_solve(reuse);
    report.linear_iterations += linear.iterations;
    if (!linear.solved)
      return fail(linear.reason);
    if (linear.factorised) {
      report.negative_pivots = linear.negative_pivots;
      report.most_negative_pivots = std::max(report.most_negative_pivots, linear.negative_pivots);
      ++report.factorisations;
    }

    double step = 1.;
    for (;; step /= 2.) {
      if (step < smallest_step)
        return without_residual(system, residual, " however short the step along the correction",
                                report);
      system.move_to(step);
      residual = system.residual();
      if (residual.admissible())
        break;
    }
    ++report.iterations;
    report.reused = !linear.factorised;
    report.residuals.push_back(residual.norm);
    reuse = step == 1. && worth_reusing(report, linear);
    report.min_det_F = residual.min_det_F;
    if (residual.norm > divergence)
      return fail("the residual diverges");
    report.converged = step == 1. && (residual.norm <= tolerance ||
                                      (linear.factorised && is_rounding(system, report)));
  }
  return report;
}

NewtonEffort Newton::refine(NonlinearSystem& system, const double residual) const
{
  constexpr double rounding = 0.5; // a residual that falls no faster is made of it
  NewtonEffort effort;
  double before = system.residual().norm;
  while (before > residual) {
    const LinearReport linear = system.linear_solve(true);
    effort.add({1, linear.factorised ? 1u : 0u, linear.iterations});
    if (!linear.solved)
      break;
    system.move_to(1.);
    const double after = system.residual().norm;
    if (!(after < before)) {
      system.move_to(0.);
      system.residual();
      break;
    }
    if (after > rounding * before)
      break;
    before = after;
  }
  return effort;
}

unsigned int Newton::telling_iterations(const NewtonReport& report) const
{
  const double near = 10. * std::max(tolerance, report.rounding);
  return std::count_if(report.residuals.begin(), report.residuals.end() - 1,
                       [&](const double before) { return before > near; });
}

} // namespace thelma
