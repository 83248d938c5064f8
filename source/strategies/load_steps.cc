#include <thelma/strategies/load_steps.h>
#include <thelma/strategies/ridge.h>

#include <algorithm>
#include <limits>

namespace thelma
{

template <int dim>
void LoadSteps<dim>::start(const double resolution)
{
  state.start();
  stepper.start(resolution);
}

template <int dim>
void LoadSteps<dim>::start(const double resolution, const double first_step)
{
  stepper.start(resolution, first_step);
}

/// At a load so small that the body answers linearly, the tangent at rest finds in which direction
/// the path leaves. The first step can be foretold from there, and multiplies the errors of both
/// states: they are corrected on until these are small against their distance.
template <int dim>
void LoadSteps<dim>::leave_rest()
{
  constexpr double small = 1. / 32.; // of the first step
  constexpr double error = 1e-6;     // of a residual against that of the small load
  const Newton& newton = equilibrium.solver();
  const double load = small * stepper.step();
  path->go_to(load);
  const double change = system.residual().norm;
  path->go_to(0.);
  spent.newton.add(newton.refine(system, error * change));
  state.start();
  path->go_to(load);
  const NewtonReport report = newton.solve(system, true);
  spent.newton.add(report);
  if (!report.converged)
    return state.restore();
  spent.newton.add(newton.refine(system, error * change));
  state.accept(load);
}

template <int dim>
StepReport LoadSteps<dim>::advance()
{
  StepReport step;
  step.load = stepper.next();
  if (stepper.accepted() == 0. && step.load < 2. * state.accepted_load())
    state.forget(); // too near to foretell anything
  {
    const auto timer = timings.measure("prediction");
    predictor.predict(step.load, symmetry);
  }
  path->go_to(step.load);
  step.newton = equilibrium.find(system);
  prediction_error = predictor.prediction_error();
  if (step.newton.converged && jumps(step.newton))
    step.newton.refuse(Refusal::jump, "the state found is not the continuation of the path");
  spent.newton.add(step.newton);
  if (system.knows_stability())
    step.unstable_directions = system.unstable_directions(step.newton.negative_pivots);
  return step;
}

template <int dim>
void LoadSteps<dim>::accept(const StepReport& step, Recorder& recorder)
{
  predictor.adapt(prediction_error);
  state.accept(step.load);
  stepper.accept(equilibrium.solver().telling_iterations(step.newton), state.estimated_limit());
  StepReport now = step;
  now.next_step = stepper.step();
  now.part = step.load;
  recorder.record(now);
  has_turned = turns_soon();
}

template <int dim>
void LoadSteps<dim>::cut_back(const StepReport& step)
{
  ++spent.failed_steps;
  failure = step.newton;
  state.restore();
  predictor.adapt(std::numeric_limits<double>::infinity());
  stepper.cut_back(step.newton.refusal == Refusal::jump && system.knows_stability());
  has_turned = gives_way;
}

template <int dim>
StepsEnd LoadSteps<dim>::end() const
{
  return stepper.finished()    ? StepsEnd::target
         : has_turned          ? StepsEnd::turns
         : stepper.exhausted() ? StepsEnd::exhausted
                               : StepsEnd::none;
}

/// Whether a limit point announces itself.
template <int dim>
bool LoadSteps<dim>::turns_soon() const
{
  return gives_way && symmetry == LoadSymmetry::voltage &&
         state.estimated_limit() < state.accepted_load() + 3. * stepper.step();
}

/// Whether the state found lies on another path than the last one. That is looked into where it
/// surprises or Newton's method has come through states that are less stable than both: two wells
/// have a ridge between them, and a third of the way from the last one, at the new load, it shows,
/// be that the ridge itself or the other well: however short the way in the mode that matters.
template <int dim>
bool LoadSteps<dim>::jumps(NewtonReport& report)
{
  constexpr double trusted = 0.5;
  if (state.path().size() < 2)
    return false; // no path yet
  if (!system.knows_stability())
    return prediction_error > 1. && !stepper.finest();
  const long long most =
      std::max(state.unstable_directions, system.unstable_directions(report.negative_pivots));
  const bool passed_less_stable =
      system.is_symmetric() && system.unstable_directions(report.most_negative_pivots) > most;
  if (prediction_error < trusted && !passed_less_stable)
    return false;
  const bool has_ridge = is_beyond_ridge(system, state, predictor, most, report);
  system.residual(); // for the reactions
  return has_ridge;
}

template class LoadSteps<2>;
template class LoadSteps<3>;

} // namespace thelma
