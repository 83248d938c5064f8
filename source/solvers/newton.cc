#include <thelma/base/parameters.h>
#include <thelma/solvers/newton.h>

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
  prm.add_parameter("Reuse below", reuse_below,
                    "The tangent serves for another iteration when the residual fell below this "
                    "part of the one before; 0: a new tangent in every iteration.",
                    Double(0., 0.5));
  prm.add_parameter("Iterations", max_iterations,
                    "After so many iterations a load step counts as failed and is cut.",
                    Integer(1, 1000));
}

NewtonReport Newton::solve(NonlinearSystem& system) const
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

  bool reuse = false;
  // At least one iteration, so that every accepted state comes with a factorised tangent.
  while (!report.converged) {
    if (report.iterations == max_iterations)
      return fail("no convergence in " + std::to_string(max_iterations) + " iterations");
    const LinearReport linear = system.linear_solve(reuse);
    if (!linear.solved)
      return fail(linear.reason);
    if (!reuse) {
      report.negative_pivots = linear.negative_pivots;
      ++report.factorisations;
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
    reuse = step == 1. && residual.norm < reuse_below * report.residuals.back();
    report.residuals.push_back(residual.norm);
    report.min_det_F = residual.min_det_F;
    if (residual.norm > divergence)
      return fail("the residual diverges");
    report.converged = step == 1. && residual.norm <= tolerance;
  }
  return report;
}

} // namespace thelma
