#include <thelma/strategies/path_solver.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <limits>

namespace thelma
{

/// Displacements count in multiples of what the load has done so far per load.
template <int dim>
void PathSolver<dim>::choose_metric()
{
  const double u = state.x.block(0).l2_norm(), load = state.accepted_load();
  const double scale = u > 0. && load > 0. ? u / load : system.response().l2_norm();
  metric.weigh(scale > 0. ? 1. / (scale * scale) : 1.);
}

template <int dim>
std::vector<double> PathSolver<dim>::arc_lengths() const
{
  const std::vector<State::Accepted>& path = state.path();
  std::vector<double> arc{0.};
  for (std::size_t k = 1; k < path.size(); ++k) {
    auto difference = path[k].x.block(0);
    difference -= path[k - 1].x.block(0);
    arc.push_back(arc.back() + metric.length(difference, path[k].load - path[k - 1].load));
  }
  return arc;
}

template <int dim>
Plane PathSolver<dim>::across(const State::Accepted& from) const
{
  auto way = state.x.block(0);
  way -= from.x.block(0);
  Plane plane = metric.across(way, system.load() - from.load);
  plane.value = plane.excess(system);
  return plane;
}

template <int dim>
Plane PathSolver<dim>::across_load(const double load) const
{
  Plane plane;
  plane.normal = state.x.block(0);
  plane.normal = 0.;
  plane.load_normal = 1.;
  plane.value = load;
  return plane;
}

template <int dim>
bool PathSolver<dim>::predict(const double step)
{
  if (state.path().size() > 1) {
    const std::vector<double> arc = arc_lengths();
    system.set_load(predictor.extrapolate_along(arc, arc.back() + step, metric));
    return true;
  }
  system.residual();
  const double change = step / metric.length(system.response(), 1.);
  const LinearReport linear = system.linear_solve(true);
  failure = linear.reason;
  if (!linear.solved)
    return false;
  system.add_response(change);
  system.move_to(1.);
  system.set_load(state.accepted_load() + change);
  return true;
}

template <int dim>
typename PathSolver<dim>::Solution PathSolver<dim>::solve(const Plane& plane)
{
  BorderedSystem bordered(system, plane);
  PathState found;
  found.newton = newton.solve(bordered);
  spent.add(found.newton);
  failure = found.newton.reason;
  if (!found.newton.converged)
    return {};
  return refine_and_count(plane, found) ? Solution(found) : Solution();
}

/// What is counted is the state with the stabilisation that it needs itself, not the one of its
/// guess. Near a bifurcation noise hardly shows in the residual: the fresh tangent also corrects
/// once more, unless it is so near that this itself makes noise.
template <int dim>
bool PathSolver<dim>::refine_and_count(const Plane& plane, PathState& found)
{
  constexpr double noise = 10.; // more than rounding changes a residual
  BorderedSystem bordered(system, plane);
  system.begin();
  const double before = bordered.residual().norm;
  const LinearReport fresh = bordered.linear_solve(false);
  failure = fresh.reason;
  if (!fresh.solved)
    return false;
  const LinearReport counted = system.count_pivots(fresh.negative_pivots);
  failure = counted.reason;
  if (!counted.solved)
    return false;
  found.newton.negative_pivots = counted.negative_pivots;
  bordered.move_to(1.);
  ResidualReport residual = bordered.residual();
  if (residual.norm > noise * before) {
    bordered.move_to(0.);
    residual = bordered.residual();
  } else if (residual.norm > newton.converged_residual()) {
    spent.add(newton.refine(bordered, newton.converged_residual()));
    residual = bordered.residual();
  }
  found.newton.residuals.push_back(residual.norm);
  found.newton.min_det_F = residual.min_det_F;
  ++found.newton.iterations;
  spent.add({1, 1, 0});
  found.load = system.load();
  if (system.knows_stability())
    found.unstable_directions = system.unstable_directions(found.newton.negative_pivots);
  const auto& response = system.response();
  found.slope =
      std::copysign(1. / metric.length(response, 1.), plane.normal * response + plane.load_normal);
  return true;
}

template <int dim>
typename PathSolver<dim>::Solution PathSolver<dim>::at_load(const double load)
{
  const std::vector<State::Accepted>& path = state.path();
  const std::vector<double> arc = arc_lengths();
  const State::Accepted &last = path.back(), &before = path[path.size() - 2];
  const double part = (load - before.load) / (last.load - before.load);
  predictor.extrapolate_along(arc, arc[arc.size() - 2] + part * (arc.back() - arc[arc.size() - 2]),
                              metric);
  system.set_load(load);
  return solve(across_load(load));
}

template <int dim>
typename PathSolver<dim>::Solution PathSolver<dim>::between(const double arc)
{
  const State::Accepted &last = state.path().back(),
                        &before = state.path()[state.path().size() - 2];
  state.x = last.x;
  system.set_load(last.load);
  Plane plane = across(before);
  system.set_load(predictor.extrapolate_along(arc_lengths(), arc, metric));
  plane.value += plane.excess(system);
  Solution found = solve(plane);
  if (found)
    found->arc = arc;
  return found;
}

template <int dim>
typename PathSolver<dim>::Solution
PathSolver<dim>::locate(const double low, const double high, const double tolerance,
                        const std::function<double(const PathState&)>& value)
{
  bool lost = false;
  const auto at = [&](const double arc) {
    const Solution found = between(arc);
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

template <int dim>
void PathSolver<dim>::go_to(const State::Accepted& at)
{
  state.go_to(at);
  system.set_load(at.load);
  system.residual(); // for the reactions
}

template <int dim>
void PathSolver<dim>::start_at(const double arc)
{
  system.set_load(predictor.extrapolate_along(arc_lengths(), arc, metric));
  state.start(system.load());
}

template class PathSolver<2>;
template class PathSolver<3>;

} // namespace thelma
