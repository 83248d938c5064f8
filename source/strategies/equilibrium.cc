#include <thelma/base/option_names.h>
#include <thelma/base/parameters.h>
#include <thelma/strategies/equilibrium.h>

namespace thelma
{

void Equilibrium::declare(dealii::ParameterHandler& prm)
{
  newton.declare(prm);
  const Section section(prm, {"Stepping"});
  OptionNames<UnstableStates>({{"automatic", UnstableStates::automatic},
                               {"reject", UnstableStates::reject},
                               {"keep", UnstableStates::keep}})
      .declare(prm, "Unstable states", unstable_states,
               "Whether an equilibrium with unstable directions ends the run (`reject`) or "
               "is kept, with an event in the curve (`keep`); `automatic`: `reject` where "
               "the linear solver can count them.");
}

template <int dim>
NewtonReport Equilibrium::judged(DiscreteSystem<dim>& system, NewtonReport report) const
{
  if (!report.converged || !system.stability.is_known())
    return report;
  LinearReport counted = system.stability.count_pivots(report.negative_pivots);
  if (report.reused && counted.solved &&
      system.stability.unstable_directions(counted.negative_pivots) != 0) {
    // A count that decides is taken at the state itself.
    const LinearReport fresh = system.linear_solve(false);
    ++report.factorisations;
    counted = fresh.solved ? system.stability.count_pivots(fresh.negative_pivots) : fresh;
  }
  if (!counted.solved) {
    report.converged = false;
    report.reason = counted.reason;
    return report;
  }
  report.negative_pivots = counted.negative_pivots;
  const long long unstable = system.stability.unstable_directions(counted.negative_pivots);
  const bool rejects = unstable_states != UnstableStates::keep || requires_stable;
  if (unstable != 0 && rejects)
    report.refuse(Refusal::unstable,
                  "the state found has " + std::to_string(unstable) + " unstable direction(s)");
  return report;
}

template NewtonReport Equilibrium::judged(DiscreteSystem<2>&, NewtonReport) const;
template NewtonReport Equilibrium::judged(DiscreteSystem<3>&, NewtonReport) const;

} // namespace thelma
