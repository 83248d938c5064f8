#pragma once

#include <thelma/assembly/discrete_system.h>
#include <thelma/strategies/predictor.h>

namespace thelma
{

/// Whether a ridge separates the iterate, a stable state, from the last accepted one: whether the
/// body, held a third of the way from there at the iterate's load, has more than @p most unstable
/// directions (theory.md, "Prediction"). The iterate remains; what was solved is added to the
/// @p report.
template <int dim>
bool is_beyond_ridge(DiscreteSystem<dim>& system, State& state, Predictor<dim>& predictor,
                     long long most, NewtonReport& report);

} // namespace thelma
