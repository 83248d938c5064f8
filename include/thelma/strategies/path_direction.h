#pragma once

#include <thelma/elements/basis.h>
#include <thelma/fields/state.h>
#include <thelma/solvers/continuation.h>

#include <array>

namespace thelma
{

/// Whether the @p guess, at @p load, goes on about as the last step of a path went, from @p before
/// to @p last, by the @p metric or in the displacements alone (theory.md, eq. 79).
bool goes_on(const State::Accepted& before, const State::Accepted& last, const BlockVector& guess,
             double load, const PathMetric* metric);

/// The same of rotations and stretches, which show it at the points of @p rule: the displacements
/// of a body that rolls up turn back as it goes on. The third of the @p states is the guess; the
/// step to it is @p ratio times the one before.
template <int dim>
bool deforms_on(const DofLayout<dim>& layout, const Integration<dim>& rule,
                const std::array<const BlockVector*, 3>& states, double ratio);

} // namespace thelma
