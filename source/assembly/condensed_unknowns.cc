#include <thelma/assembly/condensed_unknowns.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace thelma
{

template <int dim>
void CondensedUnknowns<dim>::setup()
{
  residuals.assign(state.internal.size(), 0.);
  eliminations.assign(layout.cells().size() * cells.formulation().n_elimination(), 0.);
  base = correction = response = state.internal;
}

template <int dim>
void CondensedUnknowns<dim>::keep_residual(const std::size_t cell, const CellResult& result)
{
  std::copy(result.internal.begin(), result.internal.end(),
            residuals.begin() + cell * cells.formulation().n_internal());
}

template <int dim>
void CondensedUnknowns<dim>::keep_tangent(const std::size_t cell, const CellResult& result)
{
  std::copy(result.elimination.begin(), result.elimination.end(),
            eliminations.begin() + cell * cells.formulation().n_elimination());
}

template <int dim>
Elimination<dim> CondensedUnknowns<dim>::elimination(const std::size_t cell) const
{
  const Cell<dim>& whole = layout.cells()[cell];
  return {cell, whole.n_components, whole.component(Field::temperature),
          eliminations.data() + cell * cells.formulation().n_elimination(),
          residuals.data() + cell * cells.formulation().n_internal()};
}

template <int dim>
void CondensedUnknowns<dim>::eliminate(BlockVector& nodal) const
{
  if (cells.formulation().n_internal() == 0)
    return;
  std::vector<double> values;
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    values.assign(cell.dofs.size(), 0.);
    cells.formulation().eliminate(elimination(index), values.data());
    layout.scatter(cell, values, nodal);
  }
  nodal.compress(dealii::VectorOperation::add);
}

template <int dim>
void CondensedUnknowns<dim>::recover(BlockVector& x, std::vector<double>& values) const
{
  const unsigned int n_internal = cells.formulation().n_internal();
  if (n_internal == 0)
    return;
  std::vector<double> dx;
  x.update_ghost_values();
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    layout.gather(layout.cells()[index], x, dx);
    cells.formulation().recover(elimination(index), dx.data(), values.data() + index * n_internal);
  }
  x.zero_out_ghost_values();
}

template <int dim>
void CondensedUnknowns<dim>::add_response(const double change)
{
  for (std::size_t i = 0; i < correction.size(); ++i)
    correction[i] += change * response[i];
}

template <int dim>
void CondensedUnknowns<dim>::move_to(const double step)
{
  for (std::size_t i = 0; i < state.internal.size(); ++i)
    state.internal[i] = base[i] + step * correction[i];
}

template <int dim>
bool CondensedUnknowns<dim>::add_correction()
{
  constexpr double negligible = 1e-13;        // of the largest
  std::vector<double> own(2, 0.), largest(2); // correction and value
  for (std::size_t i = 0; i < state.internal.size(); ++i) {
    state.internal[i] += correction[i];
    own[0] = std::max(own[0], std::abs(correction[i]));
    own[1] = std::max(own[1], std::abs(state.internal[i]));
  }
  dealii::Utilities::MPI::max(own, layout.communicator(), largest);
  return largest[0] > negligible * largest[1];
}

template class CondensedUnknowns<2>;
template class CondensedUnknowns<3>;

} // namespace thelma
