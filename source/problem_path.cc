// What happens once the load alone no longer leads along the path.

#include <thelma/problem.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace thelma
{

template <int dim>
void Problem<dim>::follow_arc(const std::function<void(double)>& prescribe)
{
  typename PathFollowing<dim>::Task task;
  task.first_step = stepper.step();
  task.largest_step = stepper.largest_step();
  task.stop_at_limit = loading.expects_pull_in();
  for (const auto& [column, value] : loading.until())
    task.remainder = [this, column = column, value = value]() {
      return results.value(scene(), column) - value;
    };
  task.record = [this](const PathState& found) {
    results.add(scene(),
                {found.load, loading.field(state.voltage), found.step, 0.,
                 found.unstable_directions, found.event},
                found.report);
    if (found.event == "limit point" && !outcome.pull_in) {
      const double e = loading.field(state.voltage);
      outcome.pull_in = Bracket{e, e, e};
    }
  };
  task.record_mode = [this](const BlockVector& mode) { results.add_mode(scene(), mode); };
  system.load_by(prescribe);
  explain_end(path_following.follow(task));
  state.accept(system.load());
  outcome.newton_iterations += path_following.iterations();
  outcome.factorisations += path_following.factorisations();
  outcome.failed_steps += path_following.failures();
}

template <int dim>
void Problem<dim>::explain_end(const typename PathFollowing<dim>::End end)
{
  using End = typename PathFollowing<dim>::End;
  std::ostringstream where;
  where << std::setprecision(8) << " at e = " << loading.field(state.voltage);
  switch (end) {
  case End::limit_point:
    outcome.name = "pull-in";
    outcome.reason = "limit point" + where.str();
    return;
  case End::target:
  case End::observable:
    if (!loading.expects_pull_in())
      return;
    outcome = failure("target reached", "the target was reached but a pull-in was expected");
    outcome.code = ExitCode::expectation_failed;
    return;
  case End::no_load:
    outcome = failure("no load", "the path has returned to no load");
    return;
  case End::most_steps:
    outcome = failure("most steps", "the path was left after the most steps allowed" + where.str());
    return;
  case End::lost:
    outcome = failure("no convergence", "the path was lost" + where.str());
    results.set_event("no convergence");
  }
}

template void Problem<2>::follow_arc(const std::function<void(double)>&);
template void Problem<3>::follow_arc(const std::function<void(double)>&);

} // namespace thelma
