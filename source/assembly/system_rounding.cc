// How small a residual can be.

#include <thelma/assembly/system.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace thelma
{

/// Of a displacement by as much as changes the last digit of F; as unlike from node to node as
/// rounding is.
template <int dim>
BlockVector System<dim>::last_digits() const
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  BlockVector digits = layout.new_vector();
  for (const auto i : digits.locally_owned_elements())
    digits(i) = epsilon * std::sin(1. + i) * state.x(i);
  for (const Cell<dim>& cell : layout.cells())
    for (std::size_t i = 0; i < cell.dofs.size(); ++i)
      if (const auto dof = cell.dofs[i]; i % cell.n_components < dim && digits.in_local_range(dof))
        digits(dof) = epsilon * std::sin(1. + dof) *
                      (std::abs(state.x(dof)) + cell.iterator->minimum_vertex_distance());
  return digits;
}

/// By the parallelogram law of the changes that last digits make up and down.
template <int dim>
double System<dim>::rounding()
{
  const BlockVector iterate = state.x, digits = last_digits();
  const std::vector<double> internal = state.internal;
  double square = 0.;
  for (const double side : {1., -1.}) {
    state.x.add(side, digits);
    state.x.update_ghost_values();
    for (double& value : state.internal)
      value *= 1. + side * std::numeric_limits<double>::epsilon();
    square += std::pow(residual().norm, 2) / 2.;
    state.x = iterate;
    state.internal = internal;
  }
  return std::sqrt(std::max(0., square - std::pow(residual().norm, 2)));
}

#define INSTANTIATE(dim)                                                                           \
  template BlockVector System<dim>::last_digits() const;                                           \
  template double System<dim>::rounding();
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
