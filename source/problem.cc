#include <thelma/problem.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <sstream>

namespace thelma
{

template <int dim>
Problem<dim>::Problem(const MPI_Comm comm, const ParameterFile& file, std::string folder,
                      std::ostream& console)
    : scene_folder(std::filesystem::path(file.name()).parent_path().string()),
      results(comm, file, std::move(folder), console, timings), materials(file), mesh(comm),
      system(layout, conditions, state, timings), predictor(layout, conditions, state),
      path_following(system, state, predictor, newton)
{
  outcome.ranks = dealii::Utilities::MPI::n_mpi_processes(comm);
  declare();
  file.read(prm);
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
    prm.add_parameter("Value", theta,
                      "Uniform temperature in K; where the temperature is a field, its first guess "
                      "and the temperature at which e is defined.",
                      Double(1.));
  }
  loading.declare(prm);
  stepper.declare(prm);
  {
    const Section section(prm, {"Stepping"});
    prm.add_parameter("Unstable states", unstable_states,
                      "Whether an equilibrium with unstable directions ends the run (`reject`) or "
                      "is kept, with an event in the curve (`keep`).",
                      Selection("reject|keep"));
  }
  path_following.declare(prm);
  newton.declare(prm);
  results.declare(prm);
}

template <int dim>
void Problem<dim>::setup()
{
  materials.check(theta);
  {
    const auto timer = timings.measure("mesh");
    mesh.read(scene_folder);
  }
  layout.setup(mesh, materials);
  conditions.setup(mesh, layout);
  loading.setup(materials, theta);
  theta_start = materials.reference_temperature();
  state.theta = theta;
  state.x = layout.new_vector();
  if (layout.has(Field::temperature))
    state.x.block(layout.block(Field::temperature)) = theta_start;
  system.setup();
  predictor.setup(system.element());
  state.start();

  results.setup(scene(), theta);
  for (const auto& [column, value] : loading.until())
    results.require_column(column, "section Loading, entry 'Until'");

  outcome.modelled = layout.summary();
  outcome.modelled.push_back(loading.description());
  outcome.cells = mesh.triangulation().n_active_cells();
  for (const Field field : layout.fields())
    outcome.unknowns[field_name(field)] = layout.n_dofs(field);
}

template <int dim>
Outcome Problem<dim>::run()
{
  results.start(parameters(), outcome, theta);
  heat();
  if (outcome.code == ExitCode::success && layout.has(Field::potential))
    apply_voltage();
  outcome.newton_iterations += path_following.iterations();
  outcome.factorisations += path_following.factorisations();
  outcome.failed_steps += path_following.failures();
  results.finish(scene(), outcome);
  return outcome;
}

template <int dim>
void Problem<dim>::heat()
{
  Stepper steps;
  steps.start(1e-4, 1.);
  const auto prescribe = [&](const double part) {
    if (!layout.has(Field::temperature))
      state.theta = theta_start + part * (theta - theta_start);
    conditions.apply(0., theta_start, part, state.x);
  };
  NewtonReport last;
  const auto remember = [&](double, const NewtonReport& report) { last = report; };
  const auto expand = [&](const double part) {
    if (state.path().size() == 1)
      system.start_internal(); // free expansion is a better guess than none
    prescribe(part);
  };
  bool heated = follow(steps, LoadSymmetry::none, expand, remember);
  if (!heated && path_following.is_automatic()) {
    PathTask arc = task(steps);
    const auto record_on_arc = arc.record;
    arc.record = [&](const PathState& found) {
      last = found.report;
      record_on_arc(found);
    };
    heated = follow_arc(arc, prescribe) == PathEnd::target;
  }
  if (heated) {
    state.start();
    record(0., last);
  } else
    outcome = failure("no convergence", "no stable state beyond " + std::to_string(state.theta) +
                                            " K while heating: " + last_failure);
}

template <int dim>
void Problem<dim>::apply_voltage()
{
  stepper.start(loading.resolution());
  const auto prescribe = [&](const double load) {
    state.voltage = loading.voltage(load);
    conditions.apply(state.voltage, theta_start, 1., state.x);
  };
  leave_rest(prescribe);
  if (!follow(stepper, LoadSymmetry::voltage, prescribe,
              [&](const double load, const NewtonReport& report) { record(load, report); })) {
    if (path_following.is_automatic())
      return follow_voltage(prescribe);
    prescribe(state.accepted_load());
    explain_end(stepper);
  } else if (loading.expects_pull_in()) {
    outcome = failure("target reached", "the target was reached but a pull-in was expected");
    outcome.code = ExitCode::expectation_failed;
  }
}

/// At a voltage so small that the body answers linearly, the tangent at rest finds in which
/// direction the path leaves. The first step can be foretold from there.
template <int dim>
void Problem<dim>::leave_rest(const std::function<void(double)>& prescribe)
{
  constexpr double small = 1. / 32.; // of the first step
  const double load = small * stepper.step();
  prescribe(load);
  const NewtonReport report = newton.solve(system, true);
  outcome.newton_iterations += report.iterations;
  outcome.factorisations += report.factorisations;
  if (report.converged)
    state.accept(load);
  else
    state.restore();
}

template <int dim>
bool Problem<dim>::follow(Stepper& steps, const LoadSymmetry symmetry,
                          const std::function<void(double)>& prescribe, const Record& on_accept)
{
  while (!steps.finished() && !steps.exhausted()) {
    const double load = steps.next();
    {
      const auto timer = timings.measure("prediction");
      predictor.predict(load, symmetry);
    }
    prescribe(load);
    NewtonReport report = solve();
    const double surprise = predictor.surprise();
    if (report.converged && surprise > 1. && !steps.finest()) {
      report.converged = false;
      report.reason = "the state found is not the continuation of the path";
    }
    outcome.newton_iterations += report.iterations;
    outcome.factorisations += report.factorisations;
    if (!report.converged) {
      ++outcome.failed_steps;
      last_failure = report.reason;
      state.restore();
      predictor.adapt(std::numeric_limits<double>::infinity());
      steps.cut_back();
      if (hands_over(steps, symmetry, true))
        return false;
      continue;
    }
    predictor.adapt(surprise);
    state.accept(load);
    steps.accept(report.iterations, state.estimated_limit());
    on_accept(load, report);
    if (!steps.finished() && hands_over(steps, symmetry, false))
      return false;
  }
  return steps.finished();
}

/// Whether a path goes on along its arc.
template <int dim>
bool Problem<dim>::hands_over(const Stepper& steps, const LoadSymmetry symmetry,
                              const bool failed) const
{
  return path_following.is_automatic() &&
         (failed || (symmetry == LoadSymmetry::voltage && path_following.turns_soon(steps.step())));
}

template <int dim>
long long Problem<dim>::unstable_directions(const NewtonReport& report) const
{
  return system.is_symmetric() ? system.unstable_directions(report.negative_pivots) : 0;
}

/// A converged state counts only if it is stable, unless the scene says otherwise.
template <int dim>
NewtonReport Problem<dim>::solve() const
{
  NewtonReport report = newton.solve(system);
  if (report.converged && unstable_directions(report) != 0 && report.reused) {
    // A count that decides is taken at the state itself.
    report.negative_pivots = system.linear_solve(false).negative_pivots;
    ++report.factorisations;
  }
  const long long unstable = unstable_directions(report);
  const bool rejects = unstable_states == "reject" || path_following.is_automatic();
  if (report.converged && unstable != 0 && rejects) {
    report.converged = false;
    report.reason = "the state found has " + std::to_string(unstable) + " unstable direction(s)";
  }
  return report;
}

template <int dim>
void Problem<dim>::explain_end(const Stepper& steps)
{
  const auto field = [&](const double load) { return loading.field(loading.voltage(load)); };
  const double limit = state.estimated_limit();
  const Bracket bracket{field(steps.accepted()), field(steps.failed()), field(limit)};
  std::ostringstream between;
  between << std::setprecision(7) << " between e = " << bracket.e_below << " and "
          << bracket.e_above;

  // At a limit point the last states themselves announce its end, not much farther away than they
  // reach back; anything else is not a pull-in.
  const bool turns_back =
      limit < steps.failed() + std::max(10. * loading.resolution(), 2. * state.recent_span());
  if (!turns_back) {
    const bool unstable = last_failure.find("unstable") != std::string::npos;
    outcome = failure(unstable ? "instability" : "no convergence",
                      (unstable ? "loss of stability" : "no convergence") + between.str() + ": " +
                          last_failure);
    results.set_event(unstable ? "bifurcation" : "no convergence");
    return;
  }
  outcome.pull_in = bracket;
  outcome.name = "pull-in";
  outcome.reason = "pull-in" + between.str();
  results.set_event("pull-in");
  if (!loading.expects_pull_in()) {
    outcome.code = ExitCode::not_converged;
    outcome.reason += ", before the target";
  }
}

template <int dim>
void Problem<dim>::record(const double load, const NewtonReport& report)
{
  const long long unstable = unstable_directions(report);
  results.add(scene(),
              {load, loading.field(state.voltage), stepper.step(), load, unstable,
               unstable != last_unstable ? "bifurcation" : ""},
              report);
  last_unstable = unstable;
}

template <int dim>
Outcome Problem<dim>::failure(const std::string& name, const std::string& reason) const
{
  Outcome failed = outcome;
  failed.code = ExitCode::not_converged;
  failed.name = name;
  failed.reason = reason;
  return failed;
}

template <int dim>
std::string Problem<dim>::parameters() const
{
  std::ostringstream text;
  prm.print_parameters(text, dealii::ParameterHandler::Text |
                                 dealii::ParameterHandler::KeepDeclarationOrder);
  return text.str();
}

template <int dim>
bool Problem<dim>::finished() const
{
  return results.finished(parameters(), {mesh.path(scene_folder), "/proc/self/exe"});
}

template <int dim>
Scene<dim> Problem<dim>::scene() const
{
  return {materials, mesh, layout, conditions, system, state};
}

template class Problem<2>;
template class Problem<3>;

} // namespace thelma
