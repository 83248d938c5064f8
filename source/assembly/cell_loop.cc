#include <thelma/assembly/cell_loop.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

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
  memory.flows = state.rates || state.holds_without_time;
  const auto& path = state.path();
  if (!state.rates || path.empty())
    return memory;
  const std::size_t begin = cell * n_remembered * element->law_points().size();
  memory.old = path.back().history.data() + begin;
  memory.times = {state.time - path.back().load, 0., state.rates->order};
  if (path.size() > 1 && !path[path.size() - 2].history.empty()) {
    memory.older = path[path.size() - 2].history.data() + begin;
    memory.times.dt_before = path.back().load - path[path.size() - 2].load;
  }
  return memory;
}

template <int dim>
double CellLoop<dim>::memory_error() const
{
  const std::vector<double> now = state.history();
  const std::size_t n_points = element->law_points().size();
  std::vector<double> own(2, 0.), sums(2); // squares, points
  for (std::size_t cell = 0; cell < layout.cells().size(); ++cell) {
    const Material& material = *layout.cells()[cell].material;
    if (material.n_history() == 0)
      continue;
    const CellMemory of_cell = memory(cell);
    for (std::size_t q = 0; q < n_points; ++q) {
      const std::size_t first = q * n_remembered;
      own[0] += std::pow(material.step_error(of_cell.times, of_cell.old + first,
                                             of_cell.older ? of_cell.older + first : nullptr,
                                             now.data() + cell * n_points * n_remembered + first),
                         2);
    }
    own[1] += n_points;
  }
  dealii::Utilities::MPI::sum(own, layout.communicator(), sums);
  return std::sqrt(sums[0] / std::max(sums[1], 1.));
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
