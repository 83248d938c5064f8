// Where on a path a limit point or a bifurcation lies, and onto its branches.

#include <thelma/path_following.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <limits>

namespace thelma
{
namespace
{

constexpr double finest = 1e-4; ///< arc length within which events are not told from each other

} // namespace

std::string PathEvent::name() const
{
  if (kind != Kind::bifurcation)
    return kind == Kind::limit_point ? "limit point" : "";
  return multiplicity <= 1   ? "bifurcation"
         : multiplicity == 2 ? "double bifurcation"
                             : std::to_string(multiplicity) + "-fold bifurcation";
}

template <int dim>
typename PathFollowing<dim>::Solution PathFollowing<dim>::between(const double place)
{
  const State::Accepted &last = state.path().back(),
                        &before = state.path()[state.path().size() - 2];
  state.x = last.x;
  system.set_load(last.load);
  Plane plane = across(before);
  system.set_load(predictor.predict_along(places(), place, metric));
  plane.value += plane.excess(system);
  Solution found = solve(plane);
  if (found)
    found->place = place;
  return found;
}

template <int dim>
typename PathFollowing<dim>::Solution
PathFollowing<dim>::locate(const double low, const double high, const double tolerance,
                           const std::function<double(const PathState&)>& value)
{
  bool lost = false;
  const auto at = [&](const double place) {
    const Solution found = between(place);
    const double here = found && !lost ? value(*found) : std::numeric_limits<double>::quiet_NaN();
    lost = lost || !std::isfinite(here);
    return lost ? 0. : here; // zero ends the search
  };
  const double at_low = at(low), at_high = at(high);
  if (lost || at_low * at_high > 0.)
    return {};
  boost::uintmax_t evaluations = 60;
  const auto narrow = [&](const double a, const double b) { return b - a < tolerance; };
  const auto bracket =
      boost::math::tools::toms748_solve(at, low, high, at_low, at_high, narrow, evaluations);
  return lost ? Solution{} : between((bracket.first + bracket.second) / 2.);
}

/// Its load hardly depends on the place, its state does.
template <int dim>
typename PathFollowing<dim>::Solution PathFollowing<dim>::locate_limit(const double low,
                                                                       const double high)
{
  return locate(low, high, 1e-8, [](const PathState& found) { return found.slope; });
}

/// Where the smallest eigenvalue is zero; the count of unstable directions is its sign.
template <int dim>
typename PathFollowing<dim>::Solution
PathFollowing<dim>::locate_bifurcation(const double low, const double high, const long long before)
{
  Solution found = locate(low, high, 1e-8, [&](const PathState& found) {
    const double size = std::abs(system.critical_mode(mode));
    return found.unstable_directions == before ? size : -size;
  });
  if (found)
    system.critical_mode(mode);
  return found;
}

/// Intervals with several events are halved until each has one, or none can be told from another.
/// Whether all have been found.
template <int dim>
bool PathFollowing<dim>::find_events(const Place& low, const Place& high,
                                     std::vector<Event>& events)
{
  const bool turns = low.slope * high.slope < 0.;
  const long long change = std::abs(high.unstable_directions - low.unstable_directions);
  if (!turns && change == 0)
    return true;
  if (change > 1 && high.arc - low.arc > finest) {
    const Solution half = between((low.arc + high.arc) / 2.);
    if (!half)
      return false;
    const Place middle{(low.arc + high.arc) / 2., half->slope, half->unstable_directions};
    return find_events(low, middle, events) && find_events(middle, high, events);
  }
  Solution found = turns ? locate_limit(low.arc, high.arc)
                         : locate_bifurcation(low.arc, high.arc, low.unstable_directions);
  if (!found)
    return false;
  found->event = turns ? PathEvent{PathEvent::Kind::limit_point}
                       : PathEvent{PathEvent::Kind::bifurcation, change};
  events.push_back({*found, {found->load, state.x, state.internal}, turns ? BlockVector() : mode});
  return true;
}

/// Leaves the iterate at the event.
template <int dim>
typename PathFollowing<dim>::Events PathFollowing<dim>::report(const Task& task, const Event& event)
{
  state.go_to(event.at);
  system.set_load(event.at.load);
  system.residual(); // for the reactions
  task.record(event.found);
  if (event.found.event.kind == PathEvent::Kind::limit_point)
    return task.stop_at_limit ? Events::aim : Events::none;
  task.record_mode(event.mode);
  if (!chooses_branch() || on_branch)
    return Events::none;
  mode = event.mode;
  start_branch(event.found.place);
  return Events::new_branch;
}

/// Leaves the iterate at @p next, or at the event that changes what comes. Between two states of
/// one path all events are found; a step that hides one may have led to another path.
template <int dim>
typename PathFollowing<dim>::Events PathFollowing<dim>::report_events(const Task& task,
                                                                      const PathState& next)
{
  if (here.slope * next.slope > 0. && here.unstable_directions == next.unstable_directions)
    return Events::none;
  const std::vector<double> arc = places();
  std::vector<Event> events;
  const bool all = find_events({arc[arc.size() - 2], here.slope, here.unstable_directions},
                               {arc.back(), next.slope, next.unstable_directions}, events);
  if (!all && arc.back() - arc[arc.size() - 2] > finest)
    return Events::hidden;
  for (const Event& event : events)
    if (const Events what = report(task, event); what != Events::none)
      return what;
  state.restore();
  system.set_load(state.accepted_load());
  system.residual(); // for the reactions
  return Events::none;
}

/// At a bifurcation rounding decides how much of the mode a solution has. The state interpolated
/// there has none, and the branches to both sides begin alike.
template <int dim>
void PathFollowing<dim>::start_branch(const double place)
{
  on_branch = true;
  system.set_load(predictor.predict_along(places(), place, metric));
  state.start(system.load());
}

/// Step off the bifurcation along the critical mode; the load is found with the state.
template <int dim>
typename PathFollowing<dim>::Solution PathFollowing<dim>::switch_branch(double step)
{
  const double load = state.accepted_load(), sign = branch == Branch::plus ? 1. : -1.;
  while (step > 1e-6) {
    state.x.add(sign * step / metric.length(mode.block(0), 0.), mode);
    state.x.update_ghost_values();
    system.set_load(load);
    if (Solution found = solve(across(state.path().back()))) {
      state.accept(found->load);
      return found;
    }
    ++n_failures;
    state.restore();
    step /= 2.;
  }
  return {};
}

#define INSTANTIATE(dim)                                                                           \
  template typename PathFollowing<dim>::Solution PathFollowing<dim>::locate(                       \
      double, double, double, const std::function<double(const PathState&)>&);                     \
  template typename PathFollowing<dim>::Events PathFollowing<dim>::report_events(                  \
      const Task&, const PathState&);                                                              \
  template typename PathFollowing<dim>::Solution PathFollowing<dim>::switch_branch(double);
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
