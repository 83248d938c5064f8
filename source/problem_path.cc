// What happens once the load alone no longer leads along the path.

#include <thelma/problem.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace thelma
{

template <int dim>
typename PathFollowing<dim>::Task Problem<dim>::task(const Stepper& steps)
{
  PathTask task;
  task.first_step = steps.step();
  task.largest_step = stepper.largest_step();
  task.stop_at_limit = false;
  task.record = [this](const PathState& found) {
    const double e = loading.field(state.voltage);
    results.add(scene(), {found.load, e, found.step, 0., found.unstable_directions, found.event},
                found.report);
    if (found.event == "limit point" && !outcome.pull_in)
      outcome.pull_in = Bracket{e, e, e};
  };
  task.record_mode = [this](const BlockVector& mode) { results.add_mode(scene(), mode); };
  return task;
}

template <int dim>
typename PathFollowing<dim>::End
Problem<dim>::follow_arc(const PathTask& task, const std::function<void(double)>& prescribe)
{
  system.load_by(prescribe);
  const PathEnd end = path_following.follow(task);
  state.accept(system.load());
  return end;
}

template <int dim>
void Problem<dim>::follow_voltage(const std::function<void(double)>& prescribe)
{
  PathTask voltage = task(stepper);
  voltage.stop_at_limit = loading.expects_pull_in();
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
    outcome.name = "pull-in";
    outcome.reason = "limit point" + where.str();
    return;
  case PathEnd::target:
  case PathEnd::observable:
    if (!loading.expects_pull_in())
      return;
    outcome = failure("target reached", "the target was reached but a pull-in was expected");
    outcome.code = ExitCode::expectation_failed;
    return;
  case PathEnd::no_load:
    outcome = failure("no load", "the path has returned to no load");
    return;
  case PathEnd::most_steps:
    outcome = failure("most steps", "the path was left after the most steps allowed" + where.str());
    return;
  case PathEnd::lost:
    outcome = failure("no convergence", "the path was lost" + where.str());
    results.set_event("no convergence");
  }
}

#define INSTANTIATE(dim)                                                                           \
  template typename PathFollowing<dim>::Task Problem<dim>::task(const Stepper&);                   \
  template typename PathFollowing<dim>::End Problem<dim>::follow_arc(                              \
      const typename PathFollowing<dim>::Task&, const std::function<void(double)>&);               \
  template void Problem<dim>::follow_voltage(const std::function<void(double)>&);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
