#include <thelma/problem.h>

#include <limits>
#include <utility>

namespace thelma
{

/// Not where conduction finds the temperature.
template <int dim>
void Problem<dim>::set_uniform_temperature(const double value)
{
  if (layout.is_transient()) {
    state.x.block(layout.block(Field::temperature)) = value;
    state.x.update_ghost_values();
  } else if (!layout.has(Field::temperature))
    state.theta = value;
}

/// Why no step is short enough, and what helps.
template <int dim>
std::string Problem<dim>::end_in_time(const NewtonReport& last) const
{
  const std::string time = as_text(state.accepted_load()) + " s";
  if (last.converged)
    return " beyond " + time + " no time step keeps Time/Tolerance; choose a larger one";
  return ": no stable state beyond " + time + ": " + last.reason +
         (state.accepted_load() > 0. ? ""
                                     : "; against a jump at time 0 more Newton/Iterations help, or "
                                       "an amplitude that rises");
}

template <int dim>
void Problem<dim>::evolve()
{
  part = Part::time;
  if (!std::exchange(resumes, false))
    transient.start();
  transient.heated_system().set_loads(system);
  const double full = loading.voltage(1.); // 0 where a charge is the load
  while (!transient.finished()) {
    // No checkpoint holds what the search for the first step has found so far.
    if (state.path().size() > 1 && stops())
      return;
    NewtonReport report = transient.step(predictor, newton, [&]() { return solve(); });
    if (transient.is_monolithic())
      report = judged(transient.heated_system(), report);
    outcome.effort.add(report);
    if (report.converged) {
      const double surprise = predictor.surprise();
      if (transient.accept()) {
        predictor.adapt(surprise);
        record(full != 0. ? state.voltage / full : 1., report);
        continue;
      }
    } else {
      transient.cut_back();
      predictor.adapt(std::numeric_limits<double>::infinity());
    }
    ++outcome.failed_steps;
    if (transient.exhausted())
      return end_here(EndReason::no_convergence, end_in_time(report));
  }
}

template <int dim>
void Problem<dim>::record(const double load, const NewtonReport& report)
{
  const System<dim>& solved = state.rates ? scene().system : system;
  const long long unstable =
      solved.knows_stability() ? solved.unstable_directions(report.negative_pivots) : 0;
  if (layout.is_transient() && transient.is_monolithic() && !state.rates)
    transient.heated_system().residual(); // for the reactions
  show_floating_voltage();
  results.add(scene(),
              {first_load + load, loading.field(state.voltage),
               state.rates ? transient.step_size() : stepper.step(),
               state.rates ? state.time / transient.final_time() : load, unstable,
               unstable != last_unstable ? "bifurcation" : ""},
              report);
  last_unstable = unstable;
}

template <int dim>
Scene<dim> Problem<dim>::scene()
{
  const bool monolithic = layout.is_transient() && transient.is_monolithic();
  return {materials,  mesh,       layout,
          conditions, nodal_heat, monolithic ? transient.heated_system() : system,
          state};
}

template void Problem<2>::set_uniform_temperature(double);
template void Problem<3>::set_uniform_temperature(double);
template std::string Problem<2>::end_in_time(const NewtonReport&) const;
template std::string Problem<3>::end_in_time(const NewtonReport&) const;
template void Problem<2>::evolve();
template void Problem<3>::evolve();
template void Problem<2>::record(double, const NewtonReport&);
template void Problem<3>::record(double, const NewtonReport&);
template Scene<2> Problem<2>::scene();
template Scene<3> Problem<3>::scene();

} // namespace thelma
