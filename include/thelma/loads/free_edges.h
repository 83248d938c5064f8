#pragma once

#include <thelma/fields/boundary_conditions.h>

#include <string>

namespace thelma
{

/// Throws InputError, with @p place in the sentence, if the surface @p name has an edge along which
/// a pressure on it would have no energy: neither held nor in a symmetry plane.
template <int dim>
void check_edges(const Mesh<dim>& mesh, const DofLayout<dim>& layout,
                 const BoundaryConditions<dim>& conditions, const std::string& name,
                 const std::string& place);

} // namespace thelma
