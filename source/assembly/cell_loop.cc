#include <thelma/assembly/cell_loop.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace thelma
{

template <int dim>
void CellLoop<dim>::choose(const std::string& formulation, const Solved solved)
{
  fields = solved;
  element = formulations<dim>().create(formulation);
  element->setup(layout);
}

template <int dim>
void CellLoop<dim>::setup()
{
  state.internal.resize(layout.cells().size() * element->n_internal());
  initialise_internal();
  keep_memory();
}

template <int dim>
void CellLoop<dim>::initialise_internal()
{
  const unsigned int n_internal = element->n_internal();
  for (std::size_t cell = 0; cell < layout.cells().size(); ++cell)
    element->initialise_internal(*layout.cells()[cell].material, state.theta,
                                 state.internal.data() + cell * n_internal);
}

/// As many numbers for every point of every rank, so that they can be handed to other ranks.
template <int dim>
void CellLoop<dim>::keep_memory()
{
  n_remembered = 0;
  for (const Cell<dim>& cell : layout.cells())
    n_remembered = std::max(n_remembered, cell.material->n_history());
  n_remembered = dealii::Utilities::MPI::max(n_remembered, layout.communicator());
  if (n_remembered == 0 || fields == Solved::temperature)
    return;
  state.remember_by([this]() {
    const std::size_t n = std::size_t(n_remembered) * element->law_points().size();
    std::vector<double> now(layout.cells().size() * n, 0.);
    for_each([&](const CellView<dim>& view) {
      element->update_memory(view, now.data() + view.index * n);
    });
    return now;
  });
}

template <int dim>
CellMemory CellLoop<dim>::memory(const std::size_t cell) const
{
  CellMemory memory;
  memory.n = n_remembered;
  memory.rate = state.rate_without_time;
  const auto& path = state.path();
  if (!state.rates || path.empty())
    return memory;
  const std::size_t begin = cell * n_remembered * element->law_points().size();
  memory.old = path.back().history.data() + begin;
  memory.rate =
      state.has_no_step() ? std::numeric_limits<double>::infinity() : state.rates->weights[0];
  if (state.rates->n_past == 2) {
    memory.older = path[path.size() - 2].history.data() + begin;
    memory.q = state.rates->weights[2] / state.rates->weights[0];
  }
  return memory;
}

template <int dim>
Energies CellLoop<dim>::energies() const
{
  Energies sum;
  for_each([&](const CellView<dim>& view) { sum.add(1., element->energies(view)); });
  return sum;
}

template class CellLoop<2>;
template class CellLoop<3>;

} // namespace thelma
