// The unknowns inside the cells: their start, elimination, recovery and solution.

#include <thelma/assembly/system.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace thelma
{

template <int dim>
void System<dim>::start_internal()
{
  const unsigned int n_internal = formulation->n_internal();
  for (std::size_t cell = 0; cell < layout.cells().size(); ++cell)
    formulation->initialise_internal(*layout.cells()[cell].material, state.theta,
                                     state.internal.data() + cell * n_internal);
}

template <int dim>
void System<dim>::keep_elimination(const std::size_t cell, const CellResult& result)
{
  std::copy(result.elimination.begin(), result.elimination.end(),
            eliminations.begin() + cell * formulation->n_elimination());
}

template <int dim>
Elimination<dim> System<dim>::elimination(const std::size_t cell) const
{
  const Cell<dim>& whole = layout.cells()[cell];
  return {cell, whole.n_components, whole.component(Field::temperature),
          eliminations.data() + cell * formulation->n_elimination(),
          internal_residual.data() + cell * formulation->n_internal()};
}

template <int dim>
void System<dim>::eliminate_internal(BlockVector& nodal) const
{
  if (formulation->n_internal() == 0)
    return;
  std::vector<double> values;
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    values.assign(cell.dofs.size(), 0.);
    formulation->eliminate(elimination(index), values.data());
    layout.scatter(cell, values, nodal);
  }
  nodal.compress(dealii::VectorOperation::add);
}

template <int dim>
void System<dim>::recover_internal(BlockVector& x, std::vector<double>& values) const
{
  const unsigned int n_internal = formulation->n_internal();
  if (n_internal == 0)
    return;
  std::vector<double> dx;
  x.update_ghost_values();
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    layout.gather(layout.cells()[index], x, dx);
    formulation->recover(elimination(index), dx.data(), values.data() + index * n_internal);
  }
  x.zero_out_ghost_values();
}

template <int dim>
void System<dim>::relax_internal()
{
  constexpr int most = 20;
  constexpr double negligible = 1e-13; // of the largest
  CellResult result;
  nodal_correction = 0.;
  bool settled = false;
  for (int pass = 0; pass < most && !settled; ++pass) {
    residual();
    for_each_cell([&](const CellView<dim>& view) {
      formulation->tangent(view, result);
      keep_elimination(view.index, result);
    });
    recover_internal(nodal_correction, internal_correction);
    std::vector<double> own(2, 0.), largest(2); // correction and value
    for (std::size_t i = 0; i < state.internal.size(); ++i) {
      state.internal[i] += internal_correction[i];
      own[0] = std::max(own[0], std::abs(internal_correction[i]));
      own[1] = std::max(own[1], std::abs(state.internal[i]));
    }
    dealii::Utilities::MPI::max(own, layout.communicator(), largest);
    settled = !(largest[0] > negligible * largest[1]);
  }
}

#define INSTANTIATE(dim)                                                                           \
  template void System<dim>::start_internal();                                                     \
  template void System<dim>::keep_elimination(std::size_t, const CellResult&);                     \
  template Elimination<dim> System<dim>::elimination(std::size_t) const;                           \
  template void System<dim>::eliminate_internal(BlockVector&) const;                               \
  template void System<dim>::recover_internal(BlockVector&, std::vector<double>&) const;           \
  template void System<dim>::relax_internal();
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
