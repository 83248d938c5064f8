#include <thelma/base/error.h>
#include <thelma/base/parameters.h>
#include <thelma/solvers/linear_solver.h>

namespace thelma
{

/// The linear solvers a .prm can choose.
const NamedList<LinearSolver>& linear_solvers()
{
  static const NamedList<LinearSolver> list(
      "section Linear solver, entry 'Solver': unknown solver",
      {{{"direct", "MUMPS; counts unstable directions"}, make_direct_solver},
       {{"block", "FGMRES with multigrid, for large bodies"}, make_block_solver}});
  return list;
}

void LinearSettings::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  std::string names = "automatic";
  for (const std::string& name : linear_solvers().names())
    names += "|" + name;
  const Section section(prm, {"Linear solver"});
  prm.add_parameter("Solver", solver,
                    "`direct`: factorise the tangent (MUMPS), which also counts unstable "
                    "directions; `block`: FGMRES with the pressures of the cells as unknowns and "
                    "multigrid, for large bodies; `automatic`: by size and dimension.",
                    Selection(names));
  prm.add_parameter("Tolerance", tolerance,
                    "Size of the linear residual, relative to the right-hand side, at which the "
                    "block solver stops; dimensionless.",
                    Double(1e-14, 0.5));
  prm.add_parameter("Iterations", max_iterations,
                    "After so many iterations of the block solver a linear solve counts as failed.",
                    Integer(1, 10000));
}

LinearChoice choose_linear_solver(const LinearSettings& settings, const LinearProblem& problem)
{
  constexpr unsigned long long direct_limit = 200000; // doc/scaling.md
  const std::string count = std::to_string(problem.unknowns) + " unknowns";
  const bool block_works = problem.pressures_can_be_kept;
  if (settings.solver == "block" && !block_works)
    throw InputError("section Linear solver, entry 'Solver': 'block' needs element pressures; set "
                     "Discretisation/Formulation = mean dilatation, or Solver = direct");
  if (settings.solver == "block" && !problem.counts_for.empty())
    throw InputError("section Linear solver, entry 'Solver': 'block' does not count unstable "
                     "directions, which " +
                     problem.counts_for + " needs; choose direct, or change that entry");
  if (settings.solver != "automatic")
    return {settings.solver, "Linear solver/Solver says so"};
  if (problem.dimension == 2)
    return {"direct", "in two dimensions factors stay small"};
  if (problem.unknowns <= direct_limit)
    return {"direct", count + " are at most " + std::to_string(direct_limit)};
  if (problem.flatness > LinearProblem::flat)
    return {"direct", "a body of flat cells has small factors"};
  if (!block_works)
    return {"direct", "block needs element pressures"};
  if (!problem.counts_for.empty())
    return {"direct", problem.counts_for + " needs the count of unstable directions"};
  return {"block", count + " in three dimensions are more than " + std::to_string(direct_limit)};
}

} // namespace thelma
