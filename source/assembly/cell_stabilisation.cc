#include <thelma/assembly/cell_stabilisation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>

namespace thelma
{

template <int dim>
std::vector<double> CellStabilisation<dim>::needed() const
{
  std::vector<double> values(layout.cells().size(), 0.);
  cells.for_each([&](const CellView<dim>& view) {
    values[view.index] = cells.formulation().stabilisation(view);
  });
  return values;
}

template <int dim>
void CellStabilisation<dim>::begin()
{
  cells.stabilise(needed());
  lacking.clear();
  relaxation = 1.;
}

/// Aitken's relaxation: where what a state needs answers to what it has, one lack after another
/// tells how much of it to add.
template <int dim>
bool CellStabilisation<dim>::follow()
{
  constexpr double least = 0.05;
  std::vector<double> values = cells.stabilisation(), lack = needed();
  for (std::size_t i = 0; i < lack.size(); ++i)
    lack[i] -= values[i];
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
    values[i] += relaxation * lack[i];
  cells.stabilise(std::move(values));
  lacking = std::move(lack);
  return sums[0] > 0.;
}

template class CellStabilisation<2>;
template class CellStabilisation<3>;

} // namespace thelma
