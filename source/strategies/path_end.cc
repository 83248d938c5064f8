#include <thelma/strategies/path_end.h>

#include <cmath>
#include <limits>

namespace thelma
{
namespace
{

constexpr double never = std::numeric_limits<double>::infinity();

/// Slope of load^2 over the displacements at the iterate, by its own tangent; not a number if there
/// is none.
template <int dim>
double slope(DiscreteSystem<dim>& system)
{
  system.residual();
  if (!system.linear_solve(false).solved || !system.solve_load().solved)
    return std::numeric_limits<double>::quiet_NaN();
  return 2. * system.load() / system.response().l2_norm();
}

/// The load at which the slope becomes zero (theory.md, eq. 66). The last state and its tangent
/// remain.
template <int dim>
double turning_load(DiscreteSystem<dim>& system, State& state)
{
  const std::size_t n = state.path().size();
  double squares[2] = {0., 0.}, slopes[2] = {0., 0.};
  for (const std::size_t back : {2, 1}) {
    if (n < back)
      continue;
    const State::Accepted& accepted = state.path()[n - back];
    state.go_to(accepted);
    system.set_load(accepted.load);
    squares[2 - back] = accepted.load * accepted.load;
    slopes[2 - back] = std::pow(slope(system), 2);
  }
  const double fall = (slopes[0] - slopes[1]) / (squares[1] - squares[0]);
  return fall > 0. ? std::sqrt(squares[1] + slopes[1] / fall) : never;
}

} // namespace

template <int dim>
ClassifiedEnd classify_end(DiscreteSystem<dim>& system, State& state, const Refusal refusal,
                           const double failed, const double farthest)
{
  constexpr double negligible = 0.5, all = 0.95;
  ClassifiedEnd end;
  if (refusal == Refusal::no_law)
    return end;
  end.limit = turning_load(system, state);
  const bool turns = end.limit < farthest;
  if (turns)
    end.ending = PathEnding::limit_point;
  if (refusal != Refusal::unstable)
    return end;
  // The load does not push a body into the mode of a bifurcation, and does into that of a limit
  // point. Nothing is found beyond a limit point, but where it lies is foretold within the bracket.
  const bool has_mode = !std::isnan(system.stability.critical_mode(end.mode));
  if (!has_mode)
    end.mode = {};
  const double share =
      has_mode ? std::abs(end.mode.block(0) * system.response()) / system.response().l2_norm() : 0.;
  if (!turns || share < (end.limit < failed ? all : negligible))
    end.ending = PathEnding::bifurcation;
  return end;
}

template ClassifiedEnd classify_end(DiscreteSystem<2>&, State&, Refusal, double, double);
template ClassifiedEnd classify_end(DiscreteSystem<3>&, State&, Refusal, double, double);

} // namespace thelma
