// What a change of load does to the solution of the linear system, and where it becomes singular.

#include <thelma/assembly/system.h>
#include <thelma/base/axes.h>
#include <thelma/solvers/eigenpairs.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

namespace thelma
{

template <int dim>
void System<dim>::set_load(const double load)
{
  load_factor = load;
  path->go_to(load);
}

/// By central differences of the residual, which is quadratic in the potential: no formulation need
/// know what the load is.
template <int dim>
LinearReport System<dim>::solve_load()
{
  constexpr double h = 1e-4;
  const double load = load_factor;
  const BlockVector kept_residual = raw_residual;
  const std::vector<double> kept_internal = internal_residual;
  BlockVector prescribed = layout.new_vector(), rate = layout.new_vector();
  std::vector<double> internal_rate(internal_residual.size(), 0.);
  std::vector<double> charge_rate(floating.charges(0.).size(), 0.);
  for (const double side : {1., -1.}) {
    set_load(load + side * h);
    residual();
    prescribed.add(side / (2. * h), state.x);
    rate.add(side / (2. * h), raw_residual);
    const std::vector<double> charges = floating.charges(state.charge);
    for (std::size_t k = 0; k < charges.size(); ++k)
      charge_rate[k] += side / (2. * h) * charges[k];
    for (std::size_t i = 0; i < internal_rate.size(); ++i)
      internal_rate[i] += side / (2. * h) * internal_residual[i];
  }
  set_load(load);
  internal_residual = internal_rate;
  nodal_response.zero_out_ghost_values();
  nodal_response = rate;
  eliminate_internal(nodal_response);
  nodal_response *= -1.;
  const LinearReport report = solve_tangent(nodal_response, charge_rate);
  prescribed.zero_out_ghost_values();
  nodal_response += prescribed; // zero where nothing is prescribed
  recover_internal(nodal_response, internal_response);
  raw_residual = kept_residual;
  internal_residual = kept_internal;
  return report;
}

template <int dim>
void System<dim>::add_response(const double change)
{
  nodal_correction.add(change, nodal_response);
  for (std::size_t i = 0; i < internal_correction.size(); ++i)
    internal_correction[i] += change * internal_response[i];
}

/// With only forces on the right-hand side every solution obeys the other fields' equations.
template <int dim>
double System<dim>::critical_mode(BlockVector& mode)
{
  mode = layout.new_vector();
  for (const auto i : mode.block(0).locally_owned_elements())
    mode.block(0)(i) = std::sin(1. + i); // no eigenvector is without a part of it
  conditions.constraints().set_zero(mode);
  const std::vector<double> no_charge(floating.charges(0.).size(), 0.);
  BlockVector work = mode;
  bool solved = true;
  const auto solve = [&](Displacement& vector) {
    work = 0.;
    work.block(0).copy_locally_owned_data_from(vector);
    solved = solve_tangent(work, no_charge).solved && solved;
    vector.copy_locally_owned_data_from(work.block(0));
  };
  const std::optional<Eigenpair> smallest =
      smallest_eigenpair(solve, mode.block(0), is_symmetric());
  if (!smallest || !solved)
    return std::numeric_limits<double>::quiet_NaN();
  Displacement direction = smallest->vector;
  solve(direction); // for the other fields
  mode = work;
  mode *= smallest->value;
  mode *= orientation(mode) < 0. ? -1. : 1.;
  return smallest->value;
}

/// A linear functional without symmetries, so that the sign of a mode is the same on every mesh and
/// any number of ranks: the moment along an oblique direction.
template <int dim>
double System<dim>::orientation(BlockVector& mode) const
{
  const double oblique[3] = {1., 0.4, 0.7};
  double sum = 0.;
  std::vector<double> values;
  mode.update_ghost_values();
  for (const Cell<dim>& cell : layout.cells()) {
    layout.gather(cell, mode, values);
    double arm = 1.;
    for (int d = 0; d < dim; ++d)
      arm += oblique[axis<dim>(d)] * cell.iterator->center()[d];
    for (std::size_t i = 0; i < values.size(); ++i)
      if (cell.field_of(i % cell.n_components) == Field::displacement)
        sum += arm * oblique[axis<dim>(i % cell.n_components)] * values[i];
  }
  mode.zero_out_ghost_values();
  return dealii::Utilities::MPI::sum(sum, layout.communicator());
}

template void System<2>::set_load(double);
template void System<3>::set_load(double);
template LinearReport System<2>::solve_load();
template LinearReport System<3>::solve_load();
template void System<2>::add_response(double);
template void System<3>::add_response(double);
template double System<2>::critical_mode(BlockVector&);
template double System<3>::critical_mode(BlockVector&);

} // namespace thelma
