#pragma once

#include <thelma/assembly/system.h>

namespace thelma
{

/// What ends a path of stable states along which a load grows.
enum class PathEnding { limit_point, bifurcation, no_convergence };

/// Found at the last state of the path by its tangent (theory.md, "The end of a path").
struct ClassifiedEnd {
  PathEnding ending = PathEnding::no_convergence;
  double limit;       ///< load at which the path would turn back; infinity if nothing tells of one
  BlockVector mode{}; ///< critical one, of a bifurcation; may be empty
};

/// Examine the end of the path of @p state, whose loads the @p system prescribes; the state is the
/// last accepted one afterwards. The state sought next, at the load @p failed, was not accepted
/// because of @p refusal; a load above @p farthest is too far away to have ended the path.
template <int dim>
ClassifiedEnd classify_end(System<dim>& system, State& state, Refusal refusal, double failed,
                           double farthest);

} // namespace thelma
