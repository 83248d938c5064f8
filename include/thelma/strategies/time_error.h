#pragma once

#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/state.h>
#include <thelma/strategies/time_stepper.h>

#include <optional>
#include <vector>

namespace thelma
{

/// What a step of backward differences of some order to the iterate did wrong (theory.md, "Time");
/// unknown for a first step before there is a longer one to compare it with.
template <int dim>
class TimeError
{
public:
  /// @p longer: where a longer first step has led.
  TimeError(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
            const State& state, unsigned int order, const std::optional<State::Accepted>& longer)
      : layout(layout), conditions(conditions), state(state), order(order), longer(longer)
  {
  }

  /// To the temperature: root mean square over the nodes, in K.
  std::optional<StepError> of_temperature() const;

  /// To the internal variables of the laws, which are strains: root mean square over the points.
  std::optional<StepError> of_memory(unsigned int n_per_point) const;

private:
  struct Combination;
  std::optional<Combination> combination() const;

  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  const State& state;
  unsigned int order;
  const std::optional<State::Accepted>& longer;
};

} // namespace thelma
