#pragma once

#include <string>

namespace thelma
{

/// The axis of space (0, 1, 2) that direction @p d of a scene runs along. A two-dimensional scene
/// is the x1-x3 plane of the body in plane strain, so that it shares all names with its
/// three-dimensional original.
template <int dim>
constexpr int axis(const int d)
{
  return dim == 3 ? d : 2 * d;
}

/// "u1", "u3", ... for direction @p d.
template <int dim>
std::string component_name(const int d)
{
  return "u" + std::to_string(axis<dim>(d) + 1);
}

} // namespace thelma
