#pragma once

#include <string>

namespace thelma
{

/// The axis of space (0, 1, 2) that direction @p d of a scene runs along. A two-dimensional scene
/// is the x1-x3 plane of the body, in plane strain or of a body of revolution, so that it shares
/// all names with its three-dimensional original. There direction 2 runs across the plane.
template <int dim>
constexpr int axis(const int d)
{
  return dim == 3 ? d : 2 * d % 3;
}

/// Whether the displacement @p c stretches the body along the direction @p J: that across the
/// plane, around the axis of a body of revolution, is stretched by u_1 alone.
template <int dim>
constexpr bool stretches(const int c, const int J)
{
  return J < dim || c == 0;
}

/// The row of F that has this stretch; its column is axis<dim>(J).
template <int dim>
constexpr int row_of_F(const int c, const int J)
{
  return J < dim ? axis<dim>(c) : axis<dim>(J);
}

/// "u1", "u3", ... for direction @p d.
template <int dim>
std::string component_name(const int d)
{
  return "u" + std::to_string(axis<dim>(d) + 1);
}

} // namespace thelma
