#include <thelma/base/option_names.h>
#include <thelma/base/quantity.h>
#include <thelma/path_ridge.h>
#include <thelma/problem.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <limits>
#include <sstream>

namespace thelma
{

template <int dim>
Problem<dim>::Problem(const MPI_Comm comm, const ParameterFile& file, std::string folder,
                      std::ostream& console)
    : scene_folder(std::filesystem::path(file.name()).parent_path().string()),
      results(comm, file, std::move(folder), console, timings), materials(file), mesh(comm),
      system(layout, conditions, nodal_heat, state, timings),
      isothermal(layout, conditions, nodal_heat, state, timings),
      transient(layout, conditions, nodal_heat, state, timings),
      predictor(layout, conditions, state), path_following(system, state, predictor, newton)
{
  outcome.ranks = dealii::Utilities::MPI::n_mpi_processes(comm);
  declare();
  complaints.allow([&]() { file.read(prm); });
}

template <int dim>
void Problem<dim>::declare()
{
  using namespace dealii::Patterns;
  prm.add_parameter("Dimension", dimension, "2: the x1-x3 plane in plane strain; 3: space.",
                    Integer(2, 3));
  mesh.declare(prm);
  materials.declare(prm);
  layout.declare(prm);
  system.declare(prm);
  conditions.declare(prm);
  {
    const Section section(prm, {"Temperature"});
    add_quantity(
        prm, "Value", theta,
        "Uniform temperature; where the temperature is a field, its first guess or initial "
        "value and the temperature at which e is defined.",
        Quantity("K", 1., 1e4));
  }
  nodal_heat.declare(prm);
  dead_loads.declare(prm);
  pressure.declare(prm);
  loading.declare(prm);
  stepper.declare(prm);
  {
    const Section section(prm, {"Stepping"});
    OptionNames<UnstableStates>({{"automatic", UnstableStates::automatic},
                                 {"reject", UnstableStates::reject},
                                 {"keep", UnstableStates::keep}})
        .declare(prm, "Unstable states", unstable_states,
                 "Whether an equilibrium with unstable directions ends the run (`reject`) or "
                 "is kept, with an event in the curve (`keep`); `automatic`: `reject` where "
                 "the linear solver can count them.");
  }
  path_following.declare(prm);
  newton.declare(prm);
  transient.declare(prm);
  results.declare(prm);
}

template <int dim>
Outcome Problem<dim>::run()
{
  results.start(parameters(), outcome, theta, resumes);
  try {
    if (part == Part::heating)
      heat();
    if (outcome.code == ExitCode::success && part != Part::time)
      apply_loads();
    if (outcome.has_reached_target() && layout.is_transient())
      evolve();
  } catch (const OutOfMemory& error) {
    if (!state.path().empty())
      state.restore();
    outcome.end(EndReason::out_of_memory, error.what());
  }
  outcome.effort.add(path_following.effort());
  outcome.failed_steps += path_following.failures();
  results.finish(scene(), outcome);
  return outcome;
}

template <int dim>
void Problem<dim>::heat()
{
  if (!resumes)
    heating.start(1e-4, 1.);
  const auto prescribe = [&](const double part) {
    conditions.apply(0., theta_start, part, state.x);
    nodal_heat.apply(theta_start, part, part);
    set_uniform_temperature(theta_start + part * (theta - theta_start));
  };
  NewtonReport last;
  const auto remember = [&](double, const NewtonReport& report) { last = report; };
  const auto expand = [&](const double part) {
    if (state.path().size() == 1)
      system.start_internal(); // free expansion is a better guess than none
    prescribe(part);
  };
  bool heated = !on_arc && follow(heating, LoadSymmetry::none, expand, remember);
  if (!heated && outcome.code == ExitCode::success && path_following.is_automatic()) {
    PathTask arc = task(heating);
    const auto record_on_arc = arc.record;
    arc.record = [&](const PathState& found) {
      last = found.report;
      record_on_arc(found);
    };
    heated = follow_arc(arc, prescribe) == PathEnd::target;
  }
  if (heated) {
    state.start();
    part = Part::loads;
    record(0., last);
  } else if (outcome.code == ExitCode::success)
    outcome.end(EndReason::no_convergence, ": no stable state beyond " + as_text(state.theta) +
                                               " K while heating: " + last_failure.reason);
}

/// In a transient scene up to the voltage at time 0.
template <int dim>
bool Problem<dim>::follow(Stepper& steps, const LoadSymmetry symmetry,
                          const std::function<void(double)>& prescribe, const Record& on_accept)
{
  resumes = false;
  while (!steps.finished() && !steps.exhausted()) {
    if (steps.accepted() > 0. && stops()) // a checkpoint stands at a row of the curve
      return false;
    const double load = steps.next();
    if (steps.accepted() == 0. && load < 2. * state.accepted_load())
      state.forget(); // too near to foretell anything
    {
      const auto timer = timings.measure("prediction");
      predictor.predict(load, symmetry);
    }
    prescribe(load);
    NewtonReport report = solve();
    const double surprise = predictor.surprise();
    if (report.converged && jumps(report, steps))
      report.refuse(Refusal::jump, "the state found is not the continuation of the path");
    outcome.effort.add(report);
    if (!report.converged) {
      ++outcome.failed_steps;
      last_failure = report;
      state.restore();
      predictor.adapt(std::numeric_limits<double>::infinity());
      steps.cut_back(report.refusal == Refusal::jump && system.knows_stability());
      if (hands_over(steps, symmetry, true))
        return false;
      continue;
    }
    predictor.adapt(surprise);
    state.accept(load);
    steps.accept(newton.telling_iterations(report), state.estimated_limit());
    on_accept(load, report);
    if (!steps.finished() && hands_over(steps, symmetry, false))
      return false;
  }
  return steps.finished();
}

template <int dim>
NewtonReport Problem<dim>::solve() const
{
  return judged(system, newton.solve(system));
}

/// A converged state counts only if it is stable, unless the scene says otherwise.
template <int dim>
NewtonReport Problem<dim>::judged(System<dim>& solved, NewtonReport report) const
{
  if (!report.converged || !solved.knows_stability())
    return report;
  LinearReport counted = solved.count_pivots(report.negative_pivots);
  if (report.reused && counted.solved && solved.unstable_directions(counted.negative_pivots) != 0) {
    // A count that decides is taken at the state itself.
    const LinearReport fresh = solved.linear_solve(false);
    ++report.factorisations;
    counted = fresh.solved ? solved.count_pivots(fresh.negative_pivots) : fresh;
  }
  if (!counted.solved) {
    report.converged = false;
    report.reason = counted.reason;
    return report;
  }
  report.negative_pivots = counted.negative_pivots;
  const long long unstable = solved.unstable_directions(counted.negative_pivots);
  const bool rejects = unstable_states != UnstableStates::keep || path_following.is_automatic();
  if (unstable != 0 && rejects)
    report.refuse(Refusal::unstable,
                  "the state found has " + std::to_string(unstable) + " unstable direction(s)");
  return report;
}

/// Whether the state found lies on another path than the last one. That is looked into where it
/// surprises or Newton's method has come through states that are less stable than both: two wells
/// have a ridge between them, and a third of the way from the last one, at the new load, it shows,
/// be that the ridge itself or the other well: however short the way in the mode that matters.
template <int dim>
bool Problem<dim>::jumps(NewtonReport& report, const Stepper& steps)
{
  constexpr double trusted = 0.5;
  const double surprise = predictor.surprise();
  if (state.path().size() < 2)
    return false; // no path yet
  if (!system.knows_stability())
    return surprise > 1. && !steps.finest();
  const long long most =
      std::max(last_unstable, system.unstable_directions(report.negative_pivots));
  const bool passed_less_stable =
      system.is_symmetric() && system.unstable_directions(report.most_negative_pivots) > most;
  if (surprise < trusted && !passed_less_stable)
    return false;
  const bool has_ridge = is_beyond_ridge(system, state, predictor, most, report);
  system.residual(); // for the reactions
  return has_ridge;
}

/// The newest row of the curve is the last.
template <int dim>
void Problem<dim>::end_here(const EndReason why, const std::string& details)
{
  outcome.end(why, details);
  results.set_event(ending_of(why).event);
}

template <int dim>
std::string Problem<dim>::parameters() const
{
  std::ostringstream text;
  prm.print_parameters(text, dealii::ParameterHandler::PRM |
                                 dealii::ParameterHandler::KeepDeclarationOrder);
  return text.str();
}

template <int dim>
bool Problem<dim>::finished() const
{
  complaints.raise();
  return results.finished(parameters(), {mesh.path(scene_folder), "/proc/self/exe"});
}

template class Problem<2>;
template class Problem<3>;

} // namespace thelma
