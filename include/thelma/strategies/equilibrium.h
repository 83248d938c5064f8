#pragma once

#include <thelma/assembly/discrete_system.h>

#include <deal.II/base/parameter_handler.h>

namespace thelma
{

/// Finds equilibria, of which unstable ones may not count.
class Equilibrium
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Paths that are followed go on through unstable states: what the load alone finds is stable.
  void require_stable() { requires_stable = true; }

  /// Whether the scene itself asks for stable states only.
  bool rejects_by_choice() const { return unstable_states == UnstableStates::reject; }

  /// The equilibrium near the iterate of the @p system.
  template <int dim>
  NewtonReport find(DiscreteSystem<dim>& system) const
  {
    return judged(system, newton.solve(system));
  }

  /// A converged state counts only if it is stable, unless the scene says otherwise.
  template <int dim>
  NewtonReport judged(DiscreteSystem<dim>& system, NewtonReport report) const;

  const Newton& solver() const { return newton; }

private:
  enum class UnstableStates { automatic, reject, keep };

  UnstableStates unstable_states = UnstableStates::automatic;
  bool requires_stable = false;
  Newton newton;
};

} // namespace thelma
