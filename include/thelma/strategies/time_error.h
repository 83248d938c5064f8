#pragma once

#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/state.h>
#include <thelma/strategies/time_stepper.h>

#include <optional>

namespace thelma
{

/// What a step by a @p scheme to the iterate did wrong to the temperature; unknown for a first step
/// before there is a @p longer one to compare it with (theory.md, "Time").
template <int dim>
std::optional<StepError> temperature_error(const DofLayout<dim>& layout,
                                           const BoundaryConditions<dim>& conditions,
                                           const State& state, const TimeScheme& scheme,
                                           const std::optional<State::Accepted>& longer);

} // namespace thelma
