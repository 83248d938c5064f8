#pragma once

#include <thelma/fields/dof_layout.h>

#include <set>
#include <string>
#include <vector>

namespace thelma
{

/// The unknowns of @p component on the named surface, line or point, over all ranks; empty if the
/// field does not live there. Throws InputError, with @p place in the sentence, for unknown names
/// and for surfaces that touch no cell.
template <int dim>
std::set<dealii::types::global_dof_index>
dofs_on(const Mesh<dim>& mesh, const DofLayout<dim>& layout, const std::string& surface,
        const std::string& place, unsigned int component);

/// Throws InputError, with @p place in the sentence, where all of the surface @p surface lies on
/// the axis of a body of revolution: given potentials and temperatures have no effect there, or a
/// singular one.
template <int dim>
void require_off_axis(const Mesh<dim>& mesh, const std::string& surface, const std::string& place);

/// Sum of the entries @p dofs of @p x over all ranks.
double sum_over(const std::set<dealii::types::global_dof_index>& dofs, const BlockVector& x);

/// Directions (from 0) named by a text such as "u1 u3". Throws InputError, with a sentence without
/// place.
template <int dim>
std::vector<unsigned int> components_named(const std::string& text);

} // namespace thelma
