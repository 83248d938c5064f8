#pragma once

#include <thelma/output/observables/observables.h>

#include <string>

namespace thelma
{

/// Where a @p mode is largest and along which axis, as a sentence tells it.
template <int dim>
std::string describe_mode(const DofLayout<dim>& layout, BlockVector& mode);

/// The part of the gradient of a @p mode, by its square, that has no mean in the cells: near 1 for
/// a mode that alternates from cell to cell or lives inside them, small for one that the mesh
/// resolves.
template <int dim>
double part_within_cells(const DofLayout<dim>& layout, BlockVector& mode);

/// How far the field has driven the body: the largest true field and the thinnest stretch along it.
/// Empty without a field.
template <int dim>
std::string describe_field(const ObservableInput<dim>& scene);

} // namespace thelma
