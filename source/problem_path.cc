// What happens once the load alone no longer leads along the path.

#include <thelma/base/error.h>
#include <thelma/output/end_of_path.h>
#include <thelma/path_end.h>
#include <thelma/problem.h>

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

namespace thelma
{

template <int dim>
void Problem<dim>::check_path() const
{
  const std::string until = "section Loading, entry 'Until'";
  if (!path_following.is_automatic() && !loading.until().empty())
    throw InputError(until + ": only a path that is followed ends so; set Stepping/Continuation to "
                             "automatic, or remove the entry");
  if (!path_following.is_automatic() && path_following.chooses_branch())
    throw InputError(
        "section Stepping, entry 'Branch': only a path that is followed takes one; set "
        "Stepping/Continuation to automatic, or remove the entry");
  for (const auto& entry : loading.until())
    results.require_column(entry.first, until);
  if (path_following.is_automatic() && layout.is_transient())
    throw InputError(
        "section Stepping, entry 'Continuation': in time there is no load to be found; "
        "choose load");
}

/// Whether a path goes on along its arc.
template <int dim>
bool Problem<dim>::hands_over(const Stepper& steps, const LoadSymmetry symmetry,
                              const bool failed) const
{
  return path_following.is_automatic() &&
         (failed || (symmetry == LoadSymmetry::voltage && path_following.turns_soon(steps.step())));
}

/// How far a body whose end is not classified has gone, for the reason of the outcome.
template <int dim>
std::string Problem<dim>::far_gone()
{
  const std::string field = describe_field(scene());
  return field.empty() ? "" : "; " + field;
}

/// A path that turns back announces that, not much farther away than its last states reach back.
template <int dim>
void Problem<dim>::explain_end(const Stepper& steps, const std::function<void(double)>& prescribe)
{
  const std::string between = ' ' + loading.between(present.kind, present.level(steps.accepted()),
                                                    present.level(steps.failed()));
  constexpr double of_cells = 0.6; // more than in modes that the mesh resolves
  system.load_by(prescribe);
  ExaminedEnd end =
      examine_end(system, state, last_failure.refusal, steps.failed(),
                  steps.failed() + std::max(10. * loading.resolution(), 2. * state.recent_span()));
  switch (end.ending) {
  case PathEnding::limit_point:
    return explain_limit(steps, end.limit, between);
  case PathEnding::bifurcation:
    end_here(EndReason::instability, between + ": " + last_failure.reason);
    if (end.mode.n_blocks() > 0) {
      outcome.reason += "; the critical mode is " + describe_mode(layout, end.mode);
      if (part_within_cells(layout, end.mode) > of_cells)
        outcome.reason += ", and alternates from cell to cell or within cells: suspect the element "
                          "and confirm with a finer mesh, or another formulation (doc/elements.md)";
      results.add_mode(scene(), end.mode);
    }
    outcome.reason += far_gone();
    return;
  case PathEnding::no_convergence:
    end_here(EndReason::no_convergence, between + ": " + last_failure.reason + far_gone());
  }
}

template <int dim>
void Problem<dim>::explain_limit(const Stepper& steps, const double limit,
                                 const std::string& between)
{
  const auto field = [&](const double load) {
    return loading.field(loading.voltage(present.level(load)));
  };
  if (present.kind != Stage::Kind::voltage)
    return end_here(EndReason::limit_point, between);
  outcome.pull_in = Bracket{field(steps.accepted()), field(steps.failed()), field(limit)};
  end_here(EndReason::pull_in, between);
  if (!loading.expects_pull_in()) {
    outcome.code = ExitCode::not_converged;
    outcome.reason += ", before the target";
  }
}

template <int dim>
typename PathFollowing<dim>::Task Problem<dim>::task(const Stepper& steps)
{
  PathTask task;
  task.first_step = steps.step();
  task.largest_step = stepper.largest_step();
  task.stop_at_limit = false;
  task.record = [this](const PathState& found) {
    show_floating_voltage();
    const double e = loading.field(state.voltage);
    results.add(
        scene(),
        {first_load + found.load, e, found.step, 0., found.unstable_directions, found.event.name()},
        found.report);
    const bool is_of_voltage = part == Part::loads && present.kind == Stage::Kind::voltage;
    if (found.event.kind == PathEvent::Kind::limit_point && is_of_voltage && !outcome.pull_in)
      outcome.pull_in = Bracket{e, e, e};
  };
  task.stops = [this]() { return stops(); };
  task.record_mode = [this](const BlockVector& mode) { results.add_mode(scene(), mode); };
  return task;
}

template <int dim>
typename PathFollowing<dim>::End
Problem<dim>::follow_arc(const PathTask& task, const std::function<void(double)>& prescribe)
{
  system.load_by(prescribe);
  on_arc = true;
  const PathEnd end = path_following.follow(task, std::exchange(resumes, false));
  on_arc = false;
  if (end != PathEnd::stopped)
    state.accept(system.load());
  return end;
}

template <int dim>
void Problem<dim>::follow_load(const std::function<void(double)>& prescribe)
{
  PathTask voltage = task(stepper);
  voltage.stop_at_limit = loading.expects_pull_in() && present.kind == Stage::Kind::voltage;
  for (const auto& [column, value] : loading.until())
    voltage.remainder = [this, column = column, value = value]() {
      return results.value(scene(), column) - value;
    };
  explain_end(follow_arc(voltage, prescribe));
}

template <int dim>
void Problem<dim>::explain_end(const PathEnd end)
{
  std::ostringstream where;
  where << std::setprecision(8) << " at e = " << loading.field(state.voltage);
  switch (end) {
  case PathEnd::limit_point:
    outcome.ended = EndReason::pull_in;
    outcome.reason = ending_of(EndReason::limit_point).sentence + where.str();
    return;
  case PathEnd::observable:
    outcome.reason = "the path reached " + loading.until().begin()->first + " = " +
                     as_text(loading.until().begin()->second);
    return;
  case PathEnd::target:
  case PathEnd::stopped: // stops() has told why
    return;
  case PathEnd::no_load:
    outcome.end(EndReason::no_load, "");
    return;
  case PathEnd::most_steps:
    outcome.end(EndReason::most_steps, where.str());
    return;
  case PathEnd::lost:
    end_here(EndReason::no_convergence, ": the path was lost" + where.str() + ": " +
                                            path_following.last_failure() + far_gone());
  }
}

#define INSTANTIATE(dim)                                                                           \
  template void Problem<dim>::check_path() const;                                                  \
  template bool Problem<dim>::hands_over(const Stepper&, LoadSymmetry, bool) const;                \
  template void Problem<dim>::explain_end(const Stepper&, const std::function<void(double)>&);     \
  template typename PathFollowing<dim>::Task Problem<dim>::task(const Stepper&);                   \
  template typename PathFollowing<dim>::End Problem<dim>::follow_arc(                              \
      const typename PathFollowing<dim>::Task&, const std::function<void(double)>&);               \
  template void Problem<dim>::follow_load(const std::function<void(double)>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
