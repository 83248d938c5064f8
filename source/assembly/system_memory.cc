// What laws with internal variables remember at the points of the cells.

#include <thelma/assembly/system.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace thelma
{

/// As many numbers for every point of every rank, so that PartitionIndependentOrder can hand them
/// to other ranks.
template <int dim>
void System<dim>::keep_memory()
{
  n_history = 0;
  for (const Cell<dim>& cell : layout.cells())
    n_history = std::max(n_history, cell.material->n_history());
  n_history = dealii::Utilities::MPI::max(n_history, layout.communicator());
  if (n_history == 0 || solved == Solved::temperature)
    return;
  state.remember_by([this]() {
    const std::size_t n = std::size_t(n_history) * formulation->law_points().size();
    std::vector<double> now(layout.cells().size() * n, 0.);
    for_each_cell([&](const CellView<dim>& view) {
      formulation->update_memory(view, now.data() + view.index * n);
    });
    return now;
  });
}

template <int dim>
CellMemory System<dim>::memory(const std::size_t cell) const
{
  CellMemory memory;
  memory.n = n_history;
  memory.dt = state.dt();
  if (!state.path().empty() && !state.path().back().history.empty())
    memory.old =
        state.path().back().history.data() + cell * n_history * formulation->law_points().size();
  return memory;
}

template void System<2>::keep_memory();
template void System<3>::keep_memory();
template CellMemory System<2>::memory(std::size_t) const;
template CellMemory System<3>::memory(std::size_t) const;

} // namespace thelma
