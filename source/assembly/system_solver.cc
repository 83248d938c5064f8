// Which linear solver serves, and what it needs to know of the tangent.

#include <thelma/assembly/system.h>
#include <thelma/base/memory.h>

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// Longest over shortest edge of a cell, on average.
template <int dim>
double flatness(const DofLayout<dim>& layout)
{
  double sum = 0.;
  for (const Cell<dim>& cell : layout.cells()) {
    double shortest = cell.iterator->extent_in_direction(0), longest = shortest;
    for (int d = 1; d < dim; ++d) {
      const double edge = cell.iterator->extent_in_direction(d);
      shortest = std::min(shortest, edge);
      longest = std::max(longest, edge);
    }
    sum += longest / shortest;
  }
  const double n_cells = layout.cells().size();
  return dealii::Utilities::MPI::sum(sum, layout.communicator()) /
         dealii::Utilities::MPI::sum(n_cells, layout.communicator());
}

} // namespace

template <int dim>
void System<dim>::choose_solver()
{
  LinearProblem problem;
  problem.dimension = dim;
  for (const Field field : layout.fields())
    problem.unknowns += layout.n_dofs(field);
  problem.flatness = flatness(layout);
  problem.is_symmetric = is_symmetric();
  problem.pressures_can_be_kept = formulation->n_kept_pressures() > 0;
  problem.counts_for = counts_for;
  choice = choose_linear_solver(linear_settings, problem);
  if (solved == Solved::temperature)
    choice = {"direct", "the temperature alone is small"};
  solver = linear_solvers().create(choice.solver);
  solver->setup(layout.communicator(), problem, linear_settings);
}

template <int dim>
void System<dim>::keep_pressures()
{
  pressures.reset();
  corner_grids.reset();
  if (!solver->keeps_pressures())
    return;
  pressures = std::make_unique<PressureBlocks<dim>>(
      layout, conditions, *formulation,
      [this](const std::size_t cell) { return elimination(cell); });
  corner_grids = std::make_unique<P1CoarseSpaces<dim>>(layout, conditions, state);
  release_memory();
}

template <int dim>
LinearReport System<dim>::prepare_solver()
{
  std::vector<bool> is_solved;
  for (const Field field : layout.fields())
    is_solved.push_back(solves(field));
  if (pressures)
    pressures->update([this](const std::size_t index) {
      const Cell<dim>& cell = layout.cells()[index];
      return cell.material->shear_modulus(cell_temperature(layout, state, cell));
    });
  const unsigned int n_symmetric =
      is_symmetric() ? layout.fields().size() : layout.block(Field::temperature);
  LinearReport report = solver->prepare(
      {matrix.matrix(), pressures.get(), corner_grids.get(), is_solved, n_symmetric});
  if (!report.solved)
    return report;
  const LinearReport responses = floating.finish(*solver);
  report.solved = responses.solved;
  report.reason = responses.reason;
  report.iterations += responses.iterations;
  if (report.solved)
    report.negative_pivots += floating.negative_pivots();
  return report;
}

template <int dim>
std::map<std::string, double> System<dim>::imbalance() const
{
  double nonzeros = 0.;
  for (unsigned int i = 0; i < matrix.matrix().n_block_rows(); ++i)
    for (unsigned int j = 0; j < matrix.matrix().n_block_cols(); ++j)
      nonzeros += matrix.matrix().block(i, j).trilinos_matrix().NumMyNonzeros();
  const auto ratio = [&](const double own) {
    const auto share = dealii::Utilities::MPI::min_max_avg(own, layout.communicator());
    return share.max / share.avg;
  };
  return {{"cells", ratio(layout.cells().size())}, {"nonzeros", ratio(nonzeros)}};
}

template <int dim>
double System<dim>::halo() const
{
  double own = 0., needed = 0.;
  for (unsigned int b = 0; b < layout.owned().size(); ++b) {
    dealii::IndexSet others = layout.relevant()[b];
    others.subtract_set(layout.owned()[b]);
    own += layout.owned()[b].n_elements();
    needed += others.n_elements();
  }
  const MPI_Comm comm = layout.communicator();
  return dealii::Utilities::MPI::max(needed, comm) /
         dealii::Utilities::MPI::min_max_avg(own, comm).avg;
}

template <int dim>
std::string System<dim>::solver_description() const
{
  return "linear solver: " + choice.solver + ", because " + choice.reason +
         (!knows_stability() ? "; whether a state is stable remains unknown"
          : symmetric_part ? "; unstable directions are counted on a second, symmetric tangent of "
                             "displacement and potential"
                           : "");
}

template void System<2>::choose_solver();
template void System<3>::choose_solver();
template void System<2>::keep_pressures();
template void System<3>::keep_pressures();
template LinearReport System<2>::prepare_solver();
template LinearReport System<3>::prepare_solver();
template std::map<std::string, double> System<2>::imbalance() const;
template std::map<std::string, double> System<3>::imbalance() const;
template double System<2>::halo() const;
template double System<3>::halo() const;
template std::string System<2>::solver_description() const;
template std::string System<3>::solver_description() const;

} // namespace thelma
