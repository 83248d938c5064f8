// Where on a path limit points and bifurcations lie.

#include <thelma/strategies/path_events.h>

#include <cmath>

namespace thelma
{
namespace
{

constexpr double finest = 1e-4; ///< arc length within which events are not told from each other

/// What the states are like at an arc length.
struct Place {
  double arc, slope;
  long long unstable_directions;
};

/// Its load hardly depends on the place, its state does.
template <int dim>
std::optional<PathState> locate_limit(PathSolver<dim>& path, const double low, const double high)
{
  return path.locate(low, high, 1e-8, [](const PathState& found) { return found.slope; });
}

/// Where the smallest eigenvalue is zero; the count of unstable directions is its sign.
template <int dim>
std::optional<PathState> locate_bifurcation(PathSolver<dim>& path, const double low,
                                            const double high, const long long before,
                                            BlockVector& mode)
{
  const auto found = path.locate(low, high, 1e-8, [&](const PathState& found) {
    const double size = std::abs(path.critical_mode(mode));
    return found.unstable_directions == before ? size : -size;
  });
  if (found)
    path.critical_mode(mode);
  return found;
}

/// Intervals with several events are halved until each has one, or none can be told from another.
template <int dim>
bool find_between(PathSolver<dim>& path, const State& state, const Place& low, const Place& high,
                  std::vector<LocatedEvent>& events)
{
  const bool turns = low.slope * high.slope < 0.;
  const long long change = std::abs(high.unstable_directions - low.unstable_directions);
  if (!turns && change == 0)
    return true;
  if (change > 1 && high.arc - low.arc > finest) {
    const auto half = path.between((low.arc + high.arc) / 2.);
    if (!half)
      return false;
    const Place middle{(low.arc + high.arc) / 2., half->slope, half->unstable_directions};
    return find_between(path, state, low, middle, events) &&
           find_between(path, state, middle, high, events);
  }
  BlockVector mode;
  auto found = turns ? locate_limit(path, low.arc, high.arc)
                     : locate_bifurcation(path, low.arc, high.arc, low.unstable_directions, mode);
  if (!found)
    return false;
  found->event = turns ? PathEvent{PathEvent::Kind::limit_point}
                       : PathEvent{PathEvent::Kind::bifurcation, change};
  events.push_back({*found, {found->load, state.x, state.internal}, mode});
  return true;
}

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
bool find_events(PathSolver<dim>& path, const State& state, const PathState& here,
                 const PathState& next, std::vector<LocatedEvent>& events)
{
  events.clear();
  if (!differ(here, next))
    return true;
  const std::vector<double> arc = path.arc_lengths();
  const double first = arc[arc.size() - 2], last = arc.back();
  return find_between(path, state, {first, here.slope, here.unstable_directions},
                      {last, next.slope, next.unstable_directions}, events) ||
         last - first <= finest;
}

template bool find_events(PathSolver<2>&, const State&, const PathState&, const PathState&,
                          std::vector<LocatedEvent>&);
template bool find_events(PathSolver<3>&, const State&, const PathState&, const PathState&,
                          std::vector<LocatedEvent>&);

} // namespace thelma
