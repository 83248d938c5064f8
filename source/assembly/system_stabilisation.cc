// The stabilisation of the cells, which a strong field makes them need.

#include <thelma/assembly/system.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace thelma
{

template <int dim>
std::vector<double> System<dim>::needed_stabilisations() const
{
  std::vector<double> needed(layout.cells().size(), 0.);
  for_each_cell(
      [&](const CellView<dim>& view) { needed[view.index] = formulation->stabilisation(view); });
  return needed;
}

template <int dim>
void System<dim>::begin()
{
  if (solved == Solved::temperature)
    return;
  const auto timer = timings.measure("residual");
  stabilisations = needed_stabilisations();
  lacking.clear();
  relaxation = 1.;
}

/// Aitken's relaxation: where what a state needs answers to what it has, one lack after another
/// tells how much of it to add.
template <int dim>
bool System<dim>::follow()
{
  constexpr double least = 0.05;
  if (solved == Solved::temperature)
    return false;
  const auto timer = timings.measure("residual");
  std::vector<double> lack = needed_stabilisations();
  for (std::size_t i = 0; i < lack.size(); ++i)
    lack[i] -= stabilisations[i];
  std::vector<double> own(3, 0.), sums(3); // of products of lacks and their changes
  own[0] = std::inner_product(lack.begin(), lack.end(), lack.begin(), 0.);
  for (std::size_t i = 0; i < lacking.size(); ++i) {
    const double change = lack[i] - lacking[i];
    own[1] += lacking[i] * change;
    own[2] += change * change;
  }
  dealii::Utilities::MPI::sum(own, layout.communicator(), sums);
  if (sums[2] > 0.)
    relaxation = std::clamp(-relaxation * sums[1] / sums[2], least, 1.);
  for (std::size_t i = 0; i < lack.size(); ++i)
    stabilisations[i] += relaxation * lack[i];
  lacking = std::move(lack);
  return sums[0] > 0.;
}

#define INSTANTIATE(dim)                                                                           \
  template std::vector<double> System<dim>::needed_stabilisations() const;                         \
  template void System<dim>::begin();                                                              \
  template bool System<dim>::follow();
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
