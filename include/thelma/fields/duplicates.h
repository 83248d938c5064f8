#pragma once

#include <deal.II/dofs/dof_handler.h>

#include <map>

namespace thelma
{

/// Unknowns that exist twice, with the one to use instead. deal.II 9.4 unifies the vertices and
/// faces that an element with and one without potential share, but in three dimensions not the
/// inner nodes of their common lines; the body would be slit there.
///
/// Elements are those of DofLayout: 0 has every component, 1 lacks the component @p absent; all
/// others are of @p degree.
template <int dim>
std::map<dealii::types::global_dof_index, dealii::types::global_dof_index>
duplicate_dofs(const dealii::DoFHandler<dim>& dofs, unsigned int degree, unsigned int absent);

} // namespace thelma
