#pragma once

#include <thelma/strategies/path_solver.h>

#include <vector>

namespace thelma
{

/// A limit point or bifurcation of a path.
struct LocatedEvent {
  PathState found;
  State::Accepted at;
  BlockVector mode; ///< of a bifurcation
};

/// Whether something lies between two states of a path.
inline bool differ(const PathState& here, const PathState& next)
{
  return !(here.slope * next.slope > 0. && here.unstable_directions == next.unstable_directions);
}

/// Find the events between the last two accepted states, which are like @p here and @p next.
/// Whether all have been found: between two states of one path they are; a step that hides one may
/// have led to another path. The iterate becomes any state of the path.
template <int dim>
bool find_events(PathSolver<dim>& path, const State& state, const PathState& here,
                 const PathState& next, std::vector<LocatedEvent>& events);

} // namespace thelma
