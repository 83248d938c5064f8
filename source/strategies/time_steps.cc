#include <thelma/base/error.h>
#include <thelma/base/option_names.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/strategies/time_steps.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace thelma
{
namespace
{

OptionNames<StructuralHeat> structural_heats()
{
  return {{{"none", StructuralHeat::none},
           {"power", StructuralHeat::power},
           {"entropy", StructuralHeat::entropy}}};
}

/// Times in s of the accepted states.
std::vector<double> times_of(const State& state)
{
  std::vector<double> times;
  for (const State::Accepted& accepted : state.path())
    times.push_back(accepted.load);
  return times;
}

/// Whether only the temperature makes the body deform on the way from the accepted states.
template <int dim>
bool are_steady(const Loads<dim>& loads, const State& state)
{
  for (const double time : times_of(state)) {
    const std::vector<double> then = loads.levels_at(time);
    for (std::size_t i = 0; i < loads.size(); ++i)
      if (loads[i].acts_on() != Field::temperature && then[i] != loads[i].level())
        return false;
  }
  return true;
}

template <int dim>
std::string coupling_advice(const DofLayout<dim>& layout, const bool is_monolithic)
{
  const double n = layout.n_dofs(Field::displacement) +
                   (layout.has(Field::potential) ? layout.n_dofs(Field::potential) : 0);
  const double n_theta = layout.n_dofs(Field::temperature);
  // Operations of a factorisation by nested dissection, twice as many if it is unsymmetric.
  const double power = dim == 2 ? 1.5 : 2.;
  const double ratio =
      2. * std::pow(n + n_theta, power) / (std::pow(n, power) + std::pow(n_theta, power));
  std::ostringstream text;
  text << std::setprecision(2) << "coupling: " << (is_monolithic ? "monolithic" : "staggered")
       << "; staggered is cheaper, because its two matrices are symmetric and smaller: one "
       << "monolithic factorisation costs about " << ratio << " times as much";
  return text.str();
}

} // namespace

template <int dim>
void TimeSteps<dim>::declare(dealii::ParameterHandler& prm)
{
  stepper.declare(prm);
  const Section section(prm, {"Time"});
  OptionNames<Coupling>({{"staggered", Coupling::staggered}, {"monolithic", Coupling::monolithic}})
      .declare(prm, "Coupling", coupling,
               "`staggered`: temperature, then displacement and potential, two symmetric "
               "systems; `monolithic`: all at once, one unsymmetric system.");
  structural_heats().declare(
      prm, "Structural heat", structural_heat,
      "Heat made by deformation and field: `none`; `power`: H beside the "
      "constant capacity c, as in the paper; `entropy`: theta times the rate "
      "of entropy, which conserves energy.");
}

template <int dim>
void TimeSteps<dim>::check() const
{
  if (!layout.is_transient() && (loads.has_amplitudes() || structural_heat != StructuralHeat::none))
    throw InputError("section Time: nothing changes in time here; choose Analysis = transient in "
                     "the section Time or Model = transient in the section Temperature, or remove "
                     "the amplitudes and the structural heat");
}

template <int dim>
void TimeSteps<dim>::choose()
{
  heated.choose(is_monolithic() ? Solved::all : Solved::temperature);
  if (is_monolithic())
    heated.stability.count_on(deformation.stability);
}

template <int dim>
void TimeSteps<dim>::start()
{
  const AmplitudeTimes& times = loads.amplitude_times();
  stepper.start(times.kinks, times.bends);
  longer.reset();
  jumping.reset();
  parts = 1;
  accepted_levels = loads.levels();
  state.time = 0.;
  state.start();
}

/// The loads of the @p time, or so many of all parts of their way there.
template <int dim>
void TimeSteps<dim>::prescribe(const double time, const unsigned int part)
{
  const std::vector<double> levels =
      jumping ? jumping->levels(time)
              : levels_between(accepted_levels, loads.levels_at(time), double(part) / parts);
  state.time = time;
  loads.set_levels(levels);
  loads.prescribe(state);
}

/// Internal variables do not jump with the loads, and strains would seem to grow evenly meanwhile.
/// So loads that jump rise within an instant, in which nothing flows: how far they may is found as
/// on any path in time.
template <int dim>
StepReport TimeSteps<dim>::advance()
{
  StepReport step;
  if (jumping && jumping->is_over(state.accepted_load())) {
    jumping.reset();
    predictor.turn();
  }
  if (!jumping && !has_heat() && (has_memory || parts > 1)) {
    jumping = jump_ahead(loads, accepted_levels, state.accepted_load(), stepper.instant());
    parts = 1;
  }
  step.load = jumping ? stepper.next_in_jump(jumping->end) : stepper.next();
  state.rates = stepper.scheme().rates(step.load, times_of(state));
  state.rates->heat = structural_heat;
  predictor.predict(step.load, LoadSymmetry::none);
  for (unsigned int part = 1; part <= parts; ++part) {
    prescribe(step.load, part);
    NewtonReport next = solve(part == parts, part == 1);
    next.add(step.newton);
    step.newton = next;
    if (!next.converged)
      break;
  }
  if (is_monolithic())
    step.newton = equilibrium.judged(heated, step.newton);
  step.is_accurate = !step.newton.converged || stepper.tolerates(step_error);
  spent.newton.add(step.newton);
  if (system().stability.is_known())
    step.unstable_directions = system().stability.unstable_directions(step.newton.negative_pivots);
  return step;
}

template <int dim>
NewtonReport TimeSteps<dim>::solve(const bool is_last_part, const bool extrapolates)
{
  step_error = StepError{0., stepper.scheme().order};
  NewtonReport warmed;
  if (has_heat()) {
    warmed = equilibrium.solver().solve(heated);
    if (!warmed.converged)
      return warmed;
    if (is_last_part)
      include(stepper.of_temperature(
          temperature_error(layout, conditions, state, stepper.scheme(), longer)));
    if (is_last_part && !stepper.tolerates(step_error))
      return warmed;
  }
  NewtonReport report = warmed;
  if (!is_monolithic()) {
    report = deform(extrapolates);
    report.add(warmed);
  }
  if (report.converged && is_last_part && has_memory)
    include(stepper.of_memory(StepError{deformation.cells.memory_error(), stepper.scheme().order}));
  return report;
}

/// The largest error counts, and one that is unknown.
template <int dim>
void TimeSteps<dim>::include(const TimeStepper::MaybeError& relative)
{
  if (!relative || !step_error)
    step_error.reset();
  else if (relative->value >= step_error->value)
    step_error = relative;
}

/// Solve for the deformation once the temperature is known.
template <int dim>
NewtonReport TimeSteps<dim>::deform(const bool extrapolates)
{
  if (has_heat() && extrapolates && are_steady(loads, state))
    predictor.follow_temperature();
  return equilibrium.find(deformation);
}

template <int dim>
void TimeSteps<dim>::accept(const StepReport& step, Recorder& recorder)
{
  const double prediction_error = predictor.prediction_error();
  stepper.accept(step_error);
  parts = 1;
  if (has_heat())
    state.inflow = heated.heat_inflow();
  accepted_levels = loads.levels();
  state.accept(state.time);
  predictor.adapt(prediction_error);
  StepReport now = step;
  now.next_step = stepper.step();
  now.part = state.time / final_time();
  recorder.record(now);
}

/// Unless there is no state, the step was too long for the tolerance.
template <int dim>
void TimeSteps<dim>::cut_back(const StepReport& step)
{
  constexpr unsigned int most = 16;
  ++spent.failed_steps;
  failed = step;
  if (step.newton.converged) {
    stepper.accept(step_error);
    if (state.path().size() == 1)
      longer = {state.time, state.x, {}};
  }
  // back to the newest accepted state with its own time and loads, which fields and checkpoints
  // tell
  state.restore();
  state.time = state.accepted_load();
  loads.set_levels(accepted_levels);
  loads.prescribe(state);
  if (!step.newton.converged) {
    stepper.cut_back();
    if (!jumping && jump_ahead(loads, accepted_levels, state.accepted_load(), stepper.instant()))
      parts = std::min(2 * parts, most);
    predictor.adapt(std::numeric_limits<double>::infinity());
  }
  is_exhausted = stepper.exhausted();
}

template <int dim>
StepsEnd TimeSteps<dim>::end() const
{
  return stepper.finished() ? StepsEnd::target
         : is_exhausted     ? StepsEnd::exhausted
                            : StepsEnd::none;
}

template <int dim>
std::string TimeSteps<dim>::why_exhausted() const
{
  const std::string time = as_text(state.accepted_load()) + " s";
  if (failed.newton.converged)
    return ": beyond " + time + " no time step keeps the tolerances of Time; choose larger ones";
  return ": no stable state beyond " + time + ": " + failed.newton.reason +
         (state.accepted_load() > 0. ? ""
                                     : "; against a jump at time 0 more Newton/Iterations help, or "
                                       "an amplitude that rises");
}

template <int dim>
std::vector<std::string> TimeSteps<dim>::summary() const
{
  std::vector<std::string> lines{"time: " + stepper.scheme().name};
  if (has_heat()) {
    lines.front() += ", structural heat: " + structural_heats().name(structural_heat);
    lines.push_back(coupling_advice(layout, is_monolithic()));
  }
  if (has_memory)
    lines.emplace_back("viscoelastic branches: a state counts as stable if it is so over its step; "
                       "then it is stable at once, with the instantaneous stiffness, as well");
  if (const std::string sentence = stepper.steps_over(loads.amplitude_times().bends);
      !sentence.empty())
    lines.push_back(sentence);
  return lines;
}

template class TimeSteps<2>;
template class TimeSteps<3>;

} // namespace thelma
