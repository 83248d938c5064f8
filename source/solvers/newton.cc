#include <thelma/base/parameters.h>
#include <thelma/solvers/newton.h>

#include <cmath>

namespace thelma
{

void Newton::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Newton"});
  prm.add_parameter("Tolerance", tolerance,
                    "Scaled residual at which a step has converged; dimensionless: residual "
                    "stress over shear modulus.",
                    Double(1e-14, 1.));
  prm.add_parameter("Reuse tangent", reuses,
                    "Whether a factorised tangent serves for further iterations while that is "
                    "cheaper than a new one.",
                    Bool());
  prm.add_parameter("Iterations", max_iterations,
                    "After so many iterations a load step counts as failed and is cut.",
                    Integer(1, 1000));
}

bool Newton::worth_reusing(const double residual, const double contraction, const double cost) const
{
  constexpr double steady = 0.5;
  return reuses && contraction < steady &&
         std::log(residual / tolerance) < cost * std::log(1. / contraction);
}

NewtonReport Newton::solve(NonlinearSystem& system, bool reuse) const
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
    return fail("det F <= 0 at the predicted state");

  double cost = 1.;
  while (!report.converged) {
    if (report.iterations == max_iterations)
      return fail("no convergence in " + std::to_string(max_iterations) + " iterations");
    const LinearReport linear = system.linear_solve(reuse);
    if (!linear.solved)
      return fail(linear.reason);
    if (!reuse) {
      report.negative_pivots = linear.negative_pivots;
      ++report.factorisations;
      report.reused = false;
      cost = linear.cost;
    }

    double step = 1.;
    for (;; step /= 2.) {
      if (step < smallest_step)
        return fail("no step along the correction keeps det F > 0");
      system.move_to(step);
      residual = system.residual();
      if (residual.admissible())
        break;
    }
    ++report.iterations;
    report.reused = report.reused || reuse;
    reuse =
        step == 1. && worth_reusing(residual.norm, residual.norm / report.residuals.back(), cost);
    report.residuals.push_back(residual.norm);
    report.min_det_F = residual.min_det_F;
    if (residual.norm > divergence)
      return fail("the residual diverges");
    report.converged = step == 1. && residual.norm <= tolerance;
  }
  return report;
}

} // namespace thelma
