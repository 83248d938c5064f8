#include <thelma/assembly/stability.h>
#include <thelma/base/axes.h>
#include <thelma/solvers/eigenpairs.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

namespace thelma
{

template <int dim>
std::string Stability<dim>::remark() const
{
  if (!is_known())
    return "; whether a state is stable remains unknown";
  return symmetric_part ? "; unstable directions are counted on a second, symmetric tangent of "
                          "displacement and potential"
                        : "";
}

/// A steady temperature answers to the deformation. Where the sign of the determinant of the whole
/// tangent says that this changes the count, it does so in the direction that is nearest to it.
template <int dim>
LinearReport Stability<dim>::count_pivots(const long long own)
{
  if (!symmetric_part)
    return {true, "", false, own};
  const long long parity = own + linear.unstable_inside();
  symmetric_part->cells.stabilise(cells.stabilisation());
  LinearReport report = symmetric_part->linear.factorise();
  const long long counted = report.negative_pivots + symmetric_part->linear.unstable_inside();
  if (!report.solved || layout.has_transient_temperature() || (counted - parity) % 2 == 0)
    return report;
  BlockVector mode;
  const double nearest = symmetric_part->critical_mode(mode);
  if (!std::isnan(nearest))
    report.negative_pivots += nearest > 0. ? 1 : -1;
  return report;
}

template <int dim>
long long Stability<dim>::unstable_directions(const long long negative_pivots) const
{
  const long long of_stable_states =
      layout.has(Field::potential)
          ? static_cast<long long>(conditions.n_free(layout, Field::potential))
          : 0;
  const long long n_floating = linear.floating().charges(0.).size();
  const LinearSystem<dim>& counted = symmetric_part ? symmetric_part->linear : linear;
  return negative_pivots + counted.unstable_inside() - of_stable_states - n_floating;
}

/// With only forces on the right-hand side every solution obeys the other fields' equations.
template <int dim>
double Stability<dim>::critical_mode(BlockVector& mode)
{
  using Displacement = BlockVector::BlockType;
  mode = layout.new_vector();
  for (const auto i : mode.block(0).locally_owned_elements())
    mode.block(0)(i) = std::sin(1. + i); // no eigenvector is without a part of it
  conditions.constraints().set_zero(mode);
  const std::vector<double> no_charge(linear.floating().charges(0.).size(), 0.);
  BlockVector work = mode;
  bool solved = true;
  const auto solve = [&](Displacement& vector) {
    work = 0.;
    work.block(0).copy_locally_owned_data_from(vector);
    solved = linear.solve(work, no_charge).solved && solved;
    vector.copy_locally_owned_data_from(work.block(0));
  };
  const std::optional<Eigenpair> smallest =
      smallest_eigenpair(solve, mode.block(0), linear.is_symmetric());
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
double Stability<dim>::orientation(BlockVector& mode) const
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

template class Stability<2>;
template class Stability<3>;

} // namespace thelma
