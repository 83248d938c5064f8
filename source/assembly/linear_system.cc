#include <thelma/assembly/linear_system.h>
#include <thelma/base/memory.h>

#include <deal.II/base/mpi.h>

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
LinearSystem<dim>::LinearSystem(const DofLayout<dim>& layout,
                                const BoundaryConditions<dim>& conditions, const Loads<dim>& loads,
                                const HeatStorage<dim>& storage, const State& state,
                                CellLoop<dim>& cells, CondensedUnknowns<dim>& condensed,
                                const SystemSettings& settings, Timings& timings)
    : layout(layout), conditions(conditions), loads(loads), storage(storage), state(state),
      cells(cells), condensed(condensed), settings(settings), timings(timings),
      electrodes(layout, conditions)
{
}

template <int dim>
void LinearSystem<dim>::choose()
{
  LinearProblem problem;
  problem.dimension = dim;
  for (const Field field : layout.fields())
    problem.unknowns += layout.n_dofs(field);
  problem.flatness = flatness(layout);
  problem.is_symmetric = is_symmetric();
  problem.pressures_can_be_kept = cells.formulation().n_kept_pressures() > 0;
  problem.counts_for = settings.counts_for;
  choice = choose_linear_solver(settings.linear, problem);
  if (cells.solved() == Solved::temperature)
    choice = {"direct", "the temperature alone is small"};
  solver = linear_solvers().create(choice.solver);
  solver->setup(layout.communicator(), problem, settings.linear);
}

template <int dim>
void LinearSystem<dim>::setup()
{
  tangent.setup(layout, conditions,
                [this](const Cell<dim>& cell, const unsigned int c, const unsigned int d) {
                  return includes(cells.solved(), cell.field_of(c)) &&
                         includes(cells.solved(), cell.field_of(d));
                });
  electrodes.setup(cells.solved() != Solved::temperature);
  keep_pressures();
}

template <int dim>
void LinearSystem<dim>::keep_pressures()
{
  pressures.reset();
  coarse_spaces.reset();
  cells.keep_pressures(solver->keeps_pressures());
  if (!solver->keeps_pressures())
    return;
  pressures = std::make_unique<PressureBlocks<dim>>(
      layout, conditions, cells.formulation(),
      [this](const std::size_t cell) { return condensed.elimination(cell); });
  coarse_spaces = std::make_unique<P1CoarseSpaces<dim>>(layout, conditions, state);
  release_memory();
}

template <int dim>
void LinearSystem<dim>::assemble()
{
  const auto timer = timings.measure("tangent");
  CellResult result;
  tangent.clear();
  electrodes.clear();
  int unstable = 0;
  cells.for_each([&](const CellView<dim>& view) {
    cells.formulation().tangent(view, result);
    tangent.add(view.index, view.cell, result.tangent);
    electrodes.add(view.index, view.cell, result.tangent);
    unstable += result.unstable_inside;
    condensed.keep_tangent(view.index, result);
  });
  loads.add_tangent(
      state, [this](const Field field) { return includes(cells.solved(), field); }, tangent);
  tangent.finish();
  if (cells.solved() != Solved::deformation)
    storage.add_tangent(state, tangent);
  n_unstable_inside = dealii::Utilities::MPI::sum(unstable, layout.communicator());
}

template <int dim>
LinearReport LinearSystem<dim>::factorise()
{
  assemble();
  const auto timer = timings.measure("factorisation");
  LinearReport report = prepare();
  if (!report.solved)
    return report;
  last_cost = report.cost;
  const LinearReport responses = electrodes.finish(*solver);
  report.solved = responses.solved;
  report.reason = responses.reason;
  report.iterations += responses.iterations;
  if (report.solved)
    report.negative_pivots += electrodes.negative_pivots();
  return report;
}

template <int dim>
LinearReport LinearSystem<dim>::prepare()
{
  std::vector<bool> is_solved;
  for (const Field field : layout.fields())
    is_solved.push_back(includes(cells.solved(), field));
  if (pressures)
    pressures->update([this](const std::size_t index) {
      const Cell<dim>& cell = layout.cells()[index];
      return cell.material->shear_modulus(cell_temperature(layout, state, cell));
    });
  const unsigned int n_symmetric =
      is_symmetric() ? layout.fields().size() : layout.block(Field::temperature);
  return solver->prepare(
      {tangent.matrix(), pressures.get(), coarse_spaces.get(), is_solved, n_symmetric});
}

template <int dim>
LinearReport LinearSystem<dim>::solve(BlockVector& vector, const std::vector<double>& charges)
{
  std::vector<double> lacking = electrodes.sums(vector);
  for (std::size_t k = 0; k < lacking.size(); ++k)
    lacking[k] -= charges[k];
  conditions.constraints().set_zero(vector);
  for (const Field field : layout.fields())
    if (!includes(cells.solved(), field))
      vector.block(layout.block(field)) = 0.;
  LinearReport report = solver->solve(vector);
  conditions.constraints().set_zero(vector);
  electrodes.correct(lacking, vector);
  return report;
}

template class LinearSystem<2>;
template class LinearSystem<3>;

} // namespace thelma
