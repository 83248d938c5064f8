#include <thelma/assembly/discrete_system.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace thelma
{
namespace
{

/// Of a displacement by as much as changes the last digit of F; as unlike from node to node as
/// rounding is.
template <int dim>
BlockVector last_digits(const DofLayout<dim>& layout, const BlockVector& x)
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const auto owned = layout.dof_handler().locally_owned_dofs();
  BlockVector digits = layout.new_vector();
  for (const auto i : digits.locally_owned_elements())
    digits(i) = epsilon * std::sin(1. + i) * x(i);
  for (const Cell<dim>& cell : layout.cells())
    for (std::size_t i = 0; i < cell.dofs.size(); ++i)
      if (const auto dof = cell.dofs[i]; i % cell.n_components < dim && owned.is_element(dof))
        digits(dof) = epsilon * std::sin(1. + dof) *
                      (std::abs(x(dof)) + cell.iterator->minimum_vertex_distance());
  return digits;
}

} // namespace

template <int dim>
DiscreteSystem<dim>::DiscreteSystem(const DofLayout<dim>& layout,
                                    const BoundaryConditions<dim>& conditions,
                                    const Loads<dim>& loads, const HeatStorage<dim>& storage,
                                    State& state, const SystemSettings& settings, Timings& timings)
    : cells(layout, state),
      linear(layout, conditions, loads, storage, state, cells, condensed, settings, timings),
      stability(layout, conditions, cells, linear), layout(layout), conditions(conditions),
      loads(loads), storage(storage), state(state), settings(settings), timings(timings),
      stabilisation(cells, layout), condensed(cells, layout, state),
      norm(layout, conditions, storage)
{
}

template <int dim>
void DiscreteSystem<dim>::choose(const Solved fields)
{
  const auto timer = timings.measure("setup");
  cells.choose(settings.formulation, fields);
  linear.choose();
}

template <int dim>
void DiscreteSystem<dim>::setup()
{
  const auto timer = timings.measure("setup");
  raw_residual = layout.new_vector();
  base = nodal_correction = nodal_response = holding = layout.new_vector();
  state.x.update_ghost_values();
  cells.setup();
  condensed.setup();
  norm.setup(cells, state);
  linear.setup();
}

template <int dim>
void DiscreteSystem<dim>::begin()
{
  if (cells.solved() == Solved::temperature)
    return;
  const auto timer = timings.measure("residual");
  stabilisation.begin();
}

template <int dim>
bool DiscreteSystem<dim>::follow()
{
  if (cells.solved() == Solved::temperature)
    return false;
  const auto timer = timings.measure("residual");
  return stabilisation.follow();
}

template <int dim>
ResidualReport DiscreteSystem<dim>::residual()
{
  const auto timer = timings.measure("residual");
  const Solved solved = cells.solved();
  CellResult result;
  double min_det_F = std::numeric_limits<double>::max(), internal_error = 0.;
  raw_residual = 0.;
  cells.for_each([&](const CellView<dim>& view) {
    cells.formulation().residual(view, result);
    min_det_F = std::min(min_det_F, result.min_det_F);
    internal_error += result.internal_error;
    condensed.keep_residual(view.index, result);
    layout.scatter(view.cell, result.residual, raw_residual);
  });
  loads.add_forces(
      -1., state, state.x, [solved](const Field field) { return includes(solved, field); },
      raw_residual);
  raw_residual.compress(dealii::VectorOperation::add);
  if (solved != Solved::deformation)
    storage.add_residual(state, raw_residual);
  raw_residual -= holding;
  for (const Field field : layout.fields())
    if (!includes(solved, field))
      raw_residual.block(layout.block(field)) = 0.;

  ResidualReport report{0., dealii::Utilities::MPI::min(min_det_F, layout.communicator())};
  // Pressures answer to a temperature, which does not answer to them.
  if (solved != Solved::temperature)
    norm.include_internal(internal_error, report);
  norm.include_nodal(free_residual(), state, report);
  norm.include_charges(linear.floating(), raw_residual, state, report);
  return report;
}

template <int dim>
BlockVector DiscreteSystem<dim>::free_residual() const
{
  BlockVector residual = raw_residual;
  residual.zero_out_ghost_values();
  conditions.constraints().set_zero(residual);
  return residual;
}

template <int dim>
LinearReport DiscreteSystem<dim>::linear_solve(const bool reuse)
{
  base = state.x;
  condensed.begin();
  LinearReport report{true, "", false, 0, linear.cost()};
  if (!reuse || !linear.is_current()) {
    report = linear.factorise();
    if (!report.solved)
      return report;
  }
  const auto timer = timings.measure("linear solve");
  nodal_correction.zero_out_ghost_values();
  nodal_correction = raw_residual;
  condensed.eliminate(nodal_correction);
  nodal_correction *= -1.;
  const LinearReport solution =
      linear.solve(nodal_correction, linear.floating().charges(state.charge));
  condensed.correct(nodal_correction);
  report.solved = solution.solved;
  report.reason = solution.reason;
  report.iterations += solution.iterations;
  return report;
}

template <int dim>
void DiscreteSystem<dim>::move_to(const double step)
{
  state.x = base;
  state.x.add(step, nodal_correction);
  state.x.update_ghost_values();
  condensed.move_to(step);
}

template <int dim>
void DiscreteSystem<dim>::set_load(const double load)
{
  load_factor = load;
  path->go_to(load);
}

/// By central differences of the residual, which is quadratic in the potential: no formulation need
/// know what the load is.
template <int dim>
LinearReport DiscreteSystem<dim>::solve_load()
{
  constexpr double h = 1e-4;
  const double load = load_factor;
  const BlockVector kept_residual = raw_residual;
  const std::vector<double> kept_internal = condensed.residual();
  BlockVector prescribed = layout.new_vector(), rate = layout.new_vector();
  std::vector<double> internal_rate(kept_internal.size(), 0.);
  std::vector<double> charge_rate(linear.floating().charges(0.).size(), 0.);
  for (const double side : {1., -1.}) {
    set_load(load + side * h);
    residual();
    prescribed.add(side / (2. * h), state.x);
    rate.add(side / (2. * h), raw_residual);
    const std::vector<double> charges = linear.floating().charges(state.charge);
    for (std::size_t k = 0; k < charges.size(); ++k)
      charge_rate[k] += side / (2. * h) * charges[k];
    for (std::size_t i = 0; i < internal_rate.size(); ++i)
      internal_rate[i] += side / (2. * h) * condensed.residual()[i];
  }
  set_load(load);
  condensed.residual() = internal_rate;
  nodal_response.zero_out_ghost_values();
  nodal_response = rate;
  condensed.eliminate(nodal_response);
  nodal_response *= -1.;
  const LinearReport report = linear.solve(nodal_response, charge_rate);
  prescribed.zero_out_ghost_values();
  nodal_response += prescribed; // zero where nothing is prescribed
  condensed.respond(nodal_response);
  raw_residual = kept_residual;
  condensed.residual() = kept_internal;
  return report;
}

template <int dim>
void DiscreteSystem<dim>::add_response(const double change)
{
  nodal_correction.add(change, nodal_response);
  condensed.add_response(change);
}

template <int dim>
void DiscreteSystem<dim>::converge_internal()
{
  constexpr int most = 20;
  CellResult result;
  nodal_correction = 0.;
  bool changes = true;
  for (int pass = 0; pass < most && changes; ++pass) {
    residual();
    cells.for_each([&](const CellView<dim>& view) {
      cells.formulation().tangent(view, result);
      condensed.keep_tangent(view.index, result);
    });
    condensed.correct(nodal_correction);
    changes = condensed.add_correction();
  }
}

template <int dim>
HeatInflow DiscreteSystem<dim>::heat_inflow() const
{
  const auto owned = layout.dof_handler().locally_owned_dofs();
  std::vector<double> own{0., 0.}, sum(2);
  for (const auto& [unknown, theta] : conditions.heated())
    if (owned.is_element(unknown)) {
      own[0] += raw_residual(unknown);
      own[1] += raw_residual(unknown) / state.x(unknown);
    }
  dealii::Utilities::MPI::sum(own, layout.communicator(), sum);
  const HeatInflow loaded = loads.heat_inflow(layout, state), stored = storage.wall_inflow(state);
  return {sum[0] + loaded.heat + stored.heat, sum[1] + loaded.entropy + stored.entropy};
}

/// By the parallelogram law of the changes that last digits make up and down.
template <int dim>
double DiscreteSystem<dim>::rounding()
{
  const BlockVector iterate = state.x, digits = last_digits(layout, state.x);
  const std::vector<double> internal = state.internal;
  double square = 0.;
  for (const double side : {1., -1.}) {
    state.x.add(side, digits);
    state.x.update_ghost_values();
    for (double& value : state.internal)
      value *= 1. + side * std::numeric_limits<double>::epsilon();
    square += std::pow(residual().norm, 2) / 2.;
    state.x = iterate;
    state.internal = internal;
  }
  return std::sqrt(std::max(0., square - std::pow(residual().norm, 2)));
}

template class DiscreteSystem<2>;
template class DiscreteSystem<3>;

} // namespace thelma
