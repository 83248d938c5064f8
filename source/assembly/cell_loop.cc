#include <thelma/assembly/cell_loop.h>
#include <thelma/elements/basis.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

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
  n_remembered = n_of_step = 0;
  for (const Cell<dim>& cell : layout.cells()) {
    n_remembered = std::max(n_remembered, cell.material->n_history());
    n_of_step = std::max(n_of_step, cell.material->n_step());
  }
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
StepTimes CellLoop<dim>::step_times() const
{
  const auto& path = state.path();
  if (!state.rates || path.empty())
    return {};
  StepTimes times{state.time - path.back().load, 0., state.rates->order};
  if (path.size() > 1)
    times.dt_before = path.back().load - path[path.size() - 2].load;
  return times;
}

template <int dim>
CellMemory CellLoop<dim>::memory(const std::size_t cell) const
{
  CellMemory memory;
  memory.n = n_remembered;
  memory.n_step = n_of_step;
  if (n_of_step == 0 || !(state.rates || state.holds_without_time))
    return memory;
  prepare_steps();
  const std::size_t first_point = cell * element->law_points().size();
  memory.steps = steps.data() + first_point * n_of_step;
  set_accepted(first_point, memory);
  return memory;
}

/// What the last accepted states remember, from a point on.
template <int dim>
void CellLoop<dim>::set_accepted(const std::size_t first_point, CellMemory& memory) const
{
  const auto& path = state.path();
  if (!state.rates || path.empty())
    return;
  memory.old = path.back().history.data() + first_point * n_remembered;
  if (path.size() > 1 && !path[path.size() - 2].history.empty())
    memory.older = path[path.size() - 2].history.data() + first_point * n_remembered;
}

/// Every evaluation of a step from one state to one time has the same.
template <int dim>
void CellLoop<dim>::prepare_steps() const
{
  const StepKey key{state.version(), state.time, state.rates.has_value()};
  if (key == prepared)
    return;
  prepared = key;
  const std::size_t n_points = element->law_points().size();
  const StepTimes times = step_times();
  steps.assign(layout.cells().size() * n_points * n_of_step, 0.);
  for (std::size_t cell = 0; cell < layout.cells().size(); ++cell)
    for (std::size_t point = cell * n_points; point < (cell + 1) * n_points; ++point) {
      CellMemory of_point;
      set_accepted(point, of_point);
      layout.cells()[cell].material->begin_step(times, of_point.old, of_point.older,
                                                steps.data() + point * n_of_step);
    }
}

template <int dim>
double CellLoop<dim>::memory_error() const
{
  const std::vector<double> now = state.history();
  const StepTimes times = step_times();
  const std::size_t n_points = element->law_points().size();
  std::vector<double> own(2, 0.), sums(2); // squares, points
  for (std::size_t cell = 0; cell < layout.cells().size(); ++cell) {
    const Material& material = *layout.cells()[cell].material;
    if (material.n_history() == 0)
      continue;
    for (std::size_t point = cell * n_points; point < (cell + 1) * n_points; ++point) {
      CellMemory of_point;
      set_accepted(point, of_point);
      own[0] += std::pow(material.step_error(times, of_point.old, of_point.older,
                                             now.data() + point * n_remembered),
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

/// The hottest of such points speaks for all.
template <int dim>
std::string CellLoop<dim>::table_defect() const
{
  if (!layout.has(Field::temperature))
    return "";
  const Basis<dim> basis(layout.scalar_element(), element->law_points());
  std::pair<double, std::string> found; // temperature in K, sentence
  for_each([&](const CellView<dim>& view) {
    for (unsigned int q = 0; q < basis.n_points; ++q) {
      double theta = 0.;
      for (unsigned int a = 0; a < basis.n_nodes; ++a)
        theta += basis.N[q * basis.stride + a] * view.x[view.cell.unknown(a, Field::temperature)];
      if (theta > found.first)
        if (std::string defect = view.cell.material->table_defect(theta); !defect.empty())
          found = {theta, std::move(defect)};
    }
  });
  for (const auto& of_rank : dealii::Utilities::MPI::all_gather(layout.communicator(), found))
    found = std::max(found, of_rank);
  if (found.second.empty())
    return "";
  std::ostringstream text;
  text << found.second << ", without the " << std::setprecision(10) << found.first
       << " K of a point in the body; add rows that reach it";
  return text.str();
}

template class CellLoop<2>;
template class CellLoop<3>;

} // namespace thelma
