#include <thelma/base/error.h>
#include <thelma/base/option_names.h>
#include <thelma/base/parameters.h>
#include <thelma/fields/named_dofs.h>
#include <thelma/strategies/arc_length.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace thelma
{

template <int dim>
void ArcLength<dim>::declare(dealii::ParameterHandler& prm)
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
void ArcLength<dim>::setup(const Mesh<dim>& mesh, const DofLayout<dim>& layout,
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
  path.control(row.block(0));
}

template <int dim>
void ArcLength<dim>::lead(LoadPath& along, const Aim& where)
{
  aim = where;
  ended = StepsEnd::none;
  remainder.reset();
  system.load_along(&along);
}

template <int dim>
void ArcLength<dim>::start()
{
  here = {};
  n_steps = 0;
  system.set_load(state.accepted_load());
  if (!path.refine_and_count(path.across_load(system.load()), here)) {
    ended = StepsEnd::exhausted;
    return;
  }
  path.choose_metric();
  if (!path.refine_and_count(path.across_load(system.load()), here)) { // in that metric
    ended = StepsEnd::exhausted;
    return;
  }
  const std::vector<double> arc = path.arc_lengths();
  stepper.start(arc.size() > 1 ? arc.back() - arc[arc.size() - 2]
                               : aim.first_step / std::abs(here.slope),
                1e-8);
}

template <int dim>
void ArcLength<dim>::resume()
{
  system.set_load(state.accepted_load());
  system.residual(); // for the reactions
}

template <int dim>
StepReport ArcLength<dim>::advance()
{
  if (aim.remainder && !remainder)
    remainder = aim.remainder();
  const State::Accepted& from = state.path().back();
  const std::optional<PathState> found =
      path.predict(stepper.step()) ? path.solve(path.across(from)) : std::nullopt;
  next = found.value_or(PathState());
  is_hiding = false;
  const double prediction_error = predictor.prediction_error();
  if (!found)
    return next;
  if (prediction_error >= 1.) {
    next.newton.refuse(Refusal::jump, "the state found is not the continuation of the path");
    path.fail(next.newton.reason);
    return next;
  }
  const double rest = path.length(state.x.block(0), next.load);
  state.accept(next.load);
  predictor.adapt(prediction_error);
  stepper.accept(newton.telling_iterations(next.newton), prediction_error,
                 std::min(0.3 * rest, aim.largest_step / std::abs(next.slope)));
  next.next_step = stepper.step();
  is_hiding = !find_events(path, state, here, next, events);
  if (is_hiding)
    next.newton.refuse(Refusal::jump, "an event between two states cannot be located");
  return next;
}

template <int dim>
void ArcLength<dim>::accept(const StepReport&, Recorder& recorder)
{
  if (!pass_events(recorder))
    return;
  if (const std::optional<StepsEnd> end = finish(recorder)) {
    ended = *end;
    return;
  }
  recorder.record(next);
  here = next;
  ++n_steps;
  remainder.reset();
}

/// Record what lies between the last state and the next; a new branch that is taken begins there.
/// Whether there is a next one.
template <int dim>
bool ArcLength<dim>::pass_events(Recorder& recorder)
{
  if (!differ(here, next))
    return true;
  for (const LocatedEvent& event : events) {
    path.go_to(event.at);
    recorder.record(event.found);
    if (event.found.event.kind == PathEvent::Kind::limit_point) {
      if (!aim.stop_at_limit)
        continue;
      ended = StepsEnd::limit_point;
      return false;
    }
    recorder.record_mode(event.mode);
    if (!chooses_branch() || on_branch)
      continue;
    // Rounding decides how much of the mode a solution has. The state interpolated there has none,
    // and the branches to both sides begin alike.
    on_branch = true;
    path.start_at(event.found.arc);
    const std::optional<PathState> first = switch_branch(event.mode, stepper.step());
    next = first.value_or(PathState());
    ended = first ? StepsEnd::none : StepsEnd::exhausted;
    return first.has_value();
  }
  path.go_to(state.path().back());
  return true;
}

/// Step off the bifurcation along the critical mode; the load is found with the state.
template <int dim>
std::optional<PathState> ArcLength<dim>::switch_branch(const BlockVector& mode, double step)
{
  const double load = state.accepted_load(), sign = branch == Branch::plus ? 1. : -1.;
  while (step > 1e-6) {
    state.x.add(sign * step / path.length(mode.block(0), 0.), mode);
    state.x.update_ghost_values();
    system.set_load(load);
    if (std::optional<PathState> found = path.solve(path.across(state.path().back()))) {
      state.accept(found->load);
      return found;
    }
    ++spent.failed_steps;
    state.restore();
    step /= 2.;
  }
  return {};
}

/// Whether the path ends before the next state; then the iterate is its end. What is passed in one
/// step is passed in an order.
template <int dim>
std::optional<StepsEnd> ArcLength<dim>::finish(Recorder& recorder)
{
  const bool passes_target = here.load < 1. && next.load >= 1.,
             passes_value = aim.remainder && aim.remainder() * *remainder <= 0.;
  if (!passes_target && !passes_value)
    return next.load < 0. ? std::optional<StepsEnd>(StepsEnd::no_load) : std::nullopt;
  std::optional<PathState> last;
  StepsEnd end = StepsEnd::observable;
  if (passes_value) {
    const std::vector<double> arc = path.arc_lengths();
    last = path.locate(arc[arc.size() - 2], arc.back(), 1e-10,
                       [&](const PathState&) { return aim.remainder(); });
  }
  if (passes_target && (!last || last->load > 1.)) {
    last = path.at_load(1.);
    end = StepsEnd::target;
  }
  if (!last)
    return StepsEnd::exhausted;
  recorder.record(*last);
  return end;
}

/// A state that was found but hides an event is forgotten.
template <int dim>
void ArcLength<dim>::cut_back(const StepReport&)
{
  ++spent.failed_steps;
  double length = stepper.step();
  if (is_hiding) {
    const std::vector<double> arc = path.arc_lengths();
    length = arc.back() - arc[arc.size() - 2];
    state.forget();
    ++n_steps;
  }
  state.restore();
  system.set_load(state.accepted_load());
  predictor.adapt(std::numeric_limits<double>::infinity());
  stepper.cut_back(length);
}

template <int dim>
StepsEnd ArcLength<dim>::end() const
{
  return ended != StepsEnd::none ? ended
         : stepper.exhausted()   ? StepsEnd::exhausted
         : n_steps >= most_steps ? StepsEnd::most_steps
                                 : StepsEnd::none;
}

template class ArcLength<2>;
template class ArcLength<3>;

} // namespace thelma
