#include <thelma/base/error.h>
#include <thelma/base/option_names.h>
#include <thelma/base/parameters.h>
#include <thelma/fields/named_dofs.h>
#include <thelma/path_following.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace thelma
{

template <int dim>
void PathFollowing<dim>::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Stepping"});
  OptionNames<Continuation>({{"load", Continuation::load}, {"automatic", Continuation::automatic}})
      .declare(prm, "Continuation", continuation,
               "`load`: up to the first instability; `automatic`: from there along the arc "
               "length of the path, stable or not.");
  prm.add_parameter("Controlled displacement", controlled,
                    "Mean displacement of a surface, line or point, as `top: u3`, that leads along "
                    "the path in place of its arc length. Empty: none.",
                    Map(Anything(), Anything(), 0, 1));
  check_values(prm, "Controlled displacement",
               [](const std::string& text) { components_named<dim>(text); });
  OptionNames<Branch>({{"none", Branch::none}, {"plus", Branch::plus}, {"minus", Branch::minus}})
      .declare(prm, "Branch", branch,
               "Which path the continuation takes from the first bifurcation: the old one "
               "(`none`), or the new one to either side.");
  prm.add_parameter("Most steps", most_steps, "The continuation ends after so many.", Integer(1));
}

template <int dim>
void PathFollowing<dim>::setup(const Mesh<dim>& mesh, const FieldLayout<dim>& layout,
                               const BoundaryConditions<dim>& conditions)
{
  const std::string place = "section Stepping, entry 'Controlled displacement'";
  if (controlled.empty())
    return;
  if (!is_automatic() || chooses_branch())
    throw InputError(place + ": it leads along a path only with Continuation = automatic and "
                             "Branch = none");
  const auto& [group, component] = *controlled.begin();
  BlockVector row = layout.new_vector();
  std::size_t n_free = 0;
  for (const unsigned int c : components_named<dim>(component))
    for (const auto dof : dofs_on(mesh, layout, group, place, c))
      if (!conditions.constraints().is_constrained(dof)) {
        ++n_free;
        if (row.block(0).in_local_range(dof))
          row.block(0)(dof) = 1.;
      }
  if (n_free == 0)
    throw InputError(place + ": '" + group + "' is held in the direction " + component +
                     "; choose a displacement that is free");
  row /= static_cast<double>(n_free);
  metric.choose(row.block(0));
}

/// Displacements count in multiples of what the load has done so far per load.
template <int dim>
void PathFollowing<dim>::choose_metric()
{
  const double u = state.x.block(0).l2_norm(), load = state.accepted_load();
  const double scale = u > 0. && load > 0. ? u / load : system.response().l2_norm();
  metric.weigh(scale > 0. ? 1. / (scale * scale) : 1.);
}

template <int dim>
double PathFollowing<dim>::distance(const BlockVector& a, const double load_a, const BlockVector& b,
                                    const double load_b) const
{
  auto difference = a.block(0);
  difference -= b.block(0);
  return metric.length(difference, load_a - load_b);
}

/// Arc lengths of the accepted states.
template <int dim>
std::vector<double> PathFollowing<dim>::places() const
{
  const std::vector<State::Accepted>& path = state.path();
  std::vector<double> arc{0.};
  for (std::size_t k = 1; k < path.size(); ++k)
    arc.push_back(arc.back() + distance(path[k].x, path[k].load, path[k - 1].x, path[k - 1].load));
  return arc;
}

template <int dim>
Plane PathFollowing<dim>::across(const State::Accepted& from) const
{
  auto way = state.x.block(0);
  way -= from.x.block(0);
  Plane plane = metric.across(way, system.load() - from.load);
  plane.value = plane.excess(system);
  return plane;
}

template <int dim>
Plane PathFollowing<dim>::across_load(const double load) const
{
  Plane plane;
  plane.normal = state.x.block(0);
  plane.normal = 0.;
  plane.load_normal = 1.;
  plane.value = load;
  return plane;
}

/// From a lone state along its tangent. Whether there is a guess.
template <int dim>
bool PathFollowing<dim>::predict(const double step)
{
  if (state.path().size() > 1) {
    const std::vector<double> arc = places();
    system.set_load(predictor.predict_along(arc, arc.back() + step, metric));
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
typename PathFollowing<dim>::Solution PathFollowing<dim>::solve(const Plane& plane)
{
  BorderedSystem bordered(system, plane);
  PathState found;
  found.report = newton.solve(bordered);
  spent.add(found.report);
  failure = found.report.reason;
  if (!found.report.converged)
    return {};
  return examine(plane, found) ? Solution(found) : Solution();
}

/// What is counted is the state with the stabilisation that it needs itself, not the one of its
/// guess. Near a bifurcation noise hardly shows in the residual: the fresh tangent also corrects
/// once more, unless it is so near that this itself makes noise.
template <int dim>
bool PathFollowing<dim>::examine(const Plane& plane, PathState& found)
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
  found.report.negative_pivots = counted.negative_pivots;
  bordered.move_to(1.);
  ResidualReport residual = bordered.residual();
  if (residual.norm > noise * before) {
    bordered.move_to(0.);
    residual = bordered.residual();
  } else if (residual.norm > newton.converged_residual()) {
    spent.add(newton.refine(bordered, newton.converged_residual()));
    residual = bordered.residual();
  }
  found.report.residuals.push_back(residual.norm);
  found.report.min_det_F = residual.min_det_F;
  ++found.report.iterations;
  spent.add({1, 1, 0});
  found.load = system.load();
  if (system.knows_stability())
    found.unstable_directions = system.unstable_directions(found.report.negative_pivots);
  const auto& response = system.response();
  found.slope =
      std::copysign(1. / metric.length(response, 1.), plane.normal * response + plane.load_normal);
  return true;
}

template <int dim>
typename PathFollowing<dim>::Solution PathFollowing<dim>::advance()
{
  while (!stepper.exhausted()) {
    const State::Accepted& from = state.path().back();
    Solution found = predict(stepper.step()) ? solve(across(from)) : Solution();
    const double surprise = predictor.surprise();
    if (found && surprise < 1.) {
      const double rest = metric.length(state.x.block(0), found->load);
      state.accept(found->load);
      predictor.adapt(surprise);
      stepper.accept(newton.telling_iterations(found->report), surprise,
                     std::min(0.3 * rest, largest_step / std::abs(found->slope)));
      found->step = stepper.step();
      return found;
    }
    if (found)
      failure = "the state found is not the continuation of the path";
    turn_back(stepper.step());
  }
  return {};
}

/// To the last accepted state, as a step of this @p length did not lead on.
template <int dim>
void PathFollowing<dim>::turn_back(const double length)
{
  ++n_failures;
  state.restore();
  system.set_load(state.accepted_load());
  predictor.adapt(std::numeric_limits<double>::infinity());
  stepper.cut_back(length);
}

template <int dim>
typename PathFollowing<dim>::Solution PathFollowing<dim>::land_on_target()
{
  const std::vector<State::Accepted>& path = state.path();
  const std::vector<double> arc = places();
  const State::Accepted &last = path.back(), &before = path[path.size() - 2];
  const double part = (1. - before.load) / (last.load - before.load);
  predictor.predict_along(arc, arc[arc.size() - 2] + part * (arc.back() - arc[arc.size() - 2]),
                          metric);
  system.set_load(1.);
  return solve(across_load(1.));
}

/// Whether there is a direction to go on in.
template <int dim>
bool PathFollowing<dim>::begin(const Task& task)
{
  here = {};
  n_steps = 0;
  system.set_load(state.accepted_load());
  if (!examine(across_load(system.load()), here))
    return false;
  choose_metric();
  if (!examine(across_load(system.load()), here)) // in that metric
    return false;
  const std::vector<double> arc = places();
  stepper.start(arc.size() > 1 ? arc.back() - arc[arc.size() - 2]
                               : task.first_step / std::abs(here.slope),
                1e-8);
  return true;
}

template <int dim>
void PathFollowing<dim>::resume()
{
  system.set_load(state.accepted_load());
  system.residual(); // for the reactions
}

/// Whether the path ends before @p next; then the iterate is its end. What is passed in one step is
/// passed in an order.
template <int dim>
std::optional<typename PathFollowing<dim>::End> PathFollowing<dim>::finish(const Task& task,
                                                                           const PathState& next)
{
  const bool passes_target = here.load < 1. && next.load >= 1.,
             passes_value = task.remainder && task.remainder() * remainder <= 0.;
  if (!passes_target && !passes_value)
    return next.load < 0. ? std::optional<End>(End::no_load) : std::nullopt;
  Solution last;
  End end = End::observable;
  if (passes_value) {
    const std::vector<double> arc = places();
    last = locate(arc[arc.size() - 2], arc.back(), 1e-10,
                  [&](const PathState&) { return task.remainder(); });
  }
  if (passes_target && (!last || last->load > 1.)) {
    last = land_on_target();
    end = End::target;
  }
  if (!last)
    return End::lost;
  task.record(*last);
  return end;
}

template <int dim>
typename PathFollowing<dim>::End PathFollowing<dim>::follow(const Task& task, const bool resumes)
{
  largest_step = task.largest_step;
  if (resumes)
    resume();
  else if (!begin(task))
    return End::lost;
  for (; n_steps < most_steps; ++n_steps) {
    if (n_steps > 0 && task.stops()) // before there is no second state to go on from
      return End::stopped;
    remainder = task.remainder ? task.remainder() : 0.;
    Solution next = advance();
    if (!next)
      return End::lost;
    const Events events = report_events(task, *next);
    if (events == Events::aim)
      return End::limit_point;
    if (events == Events::hidden) {
      const std::vector<double> arc = places();
      state.forget();
      turn_back(arc.back() - arc[arc.size() - 2]);
      continue;
    }
    if (events == Events::new_branch && !(next = switch_branch(stepper.step())))
      return End::lost;
    if (const std::optional<End> end = finish(task, *next))
      return *end;
    task.record(*next);
    here = *next;
  }
  return End::most_steps;
}

template class PathFollowing<2>;
template class PathFollowing<3>;

} // namespace thelma
