// The stages of a run, and what each prescribes.

#include <thelma/problem.h>

namespace thelma
{

template <int dim>
void Problem<dim>::check_stages() const
{
  const std::string place = "section Loading, entry 'Stages'";
  for (const Stage& stage : loading.stages())
    if (!stage.is_ramp())
      conditions.electrode(stage.electrode, place);
}

template <int dim>
void Problem<dim>::apply_loads()
{
  unsigned int ramps = 0;
  for (const Stage& stage : loading.stages()) {
    const bool is_electric = stage.kind != Stage::Kind::move;
    if (outcome.code != ExitCode::success || outcome.pull_in ||
        (is_electric && !layout.has(Field::potential)))
      break;
    if (!stage.is_ramp())
      change_electrode(stage);
    else {
      first_load = ramps++;
      ramp(stage);
    }
  }
}

template <int dim>
void Problem<dim>::change_electrode(const Stage& stage)
{
  const Electrode& electrode = conditions.electrode(stage.electrode, "");
  if (stage.kind == Stage::Kind::connect) {
    levels.voltage =
        potential(electrode, layout, state.x) / (electrode.voltage_multiple * loading.voltage(1.));
    conditions.connect(stage.electrode);
  } else {
    system.residual();
    const double charge =
        -dealii::Utilities::MPI::sum(electrode.own_sum(system.reactions()), layout.communicator());
    conditions.disconnect(stage.electrode, charge - electrode.charge_multiple * state.charge);
  }
}

template <int dim>
void Problem<dim>::ramp(const Stage& stage)
{
  Levels now = levels;
  double to = stage.level;
  if (layout.is_transient())
    to *= transient.initial_voltage() / loading.voltage(1.);
  const double from = levels.of(stage.kind);
  if (to == from)
    return;
  const auto prescribe = [&](const double load) {
    now.of(stage.kind) = from + load * (to - from);
    state.voltage = loading.voltage(now.voltage);
    state.charge = loading.charge(now.charge);
    conditions.set_motion(now.motion);
    conditions.apply(state.voltage, theta_start, 1., state.x);
    if (layout.is_transient())
      set_uniform_temperature(theta);
  };
  // From rest, reversing the load reverses the potential.
  const bool at_rest = levels.voltage == 0. && levels.charge == 0. && first_load == 0.;
  const LoadSymmetry symmetry =
      at_rest && stage.kind != Stage::Kind::move ? LoadSymmetry::voltage : LoadSymmetry::none;
  state.start();
  stepper.start(loading.resolution());
  leave_rest(prescribe);
  const bool finished =
      follow(stepper, symmetry, prescribe,
             [&](const double load, const NewtonReport& report) { record(load, report); });
  levels.of(stage.kind) = to;
  if (!finished && path_following.is_automatic())
    return follow_load(prescribe);
  if (!finished) {
    prescribe(state.accepted_load());
    explain_end(stepper);
  } else if (loading.expects_pull_in() && !layout.is_transient()) {
    outcome = failure("target reached", "the target was reached but a pull-in was expected");
    outcome.code = ExitCode::expectation_failed;
  }
}

/// At a voltage so small that the body answers linearly, the tangent at rest finds in which
/// direction the path leaves. The first step can be foretold from there.
template <int dim>
void Problem<dim>::leave_rest(const std::function<void(double)>& prescribe)
{
  constexpr double small = 1. / 32.; // of the first step
  const double load = small * stepper.step();
  prescribe(load);
  const NewtonReport report = newton.solve(system, true);
  outcome.newton_iterations += report.iterations;
  outcome.factorisations += report.factorisations;
  if (report.converged)
    state.accept(load);
  else
    state.restore();
}

/// The voltage of the curve is that of what carries the applied or the kept charge.
template <int dim>
void Problem<dim>::show_floating_voltage()
{
  for (const Electrode& electrode : conditions.electrodes())
    if (electrode.floats && (electrode.charge_multiple != 0. || electrode.kept_charge != 0.)) {
      state.voltage = potential(electrode, layout, state.x);
      return;
    }
}

#define INSTANTIATE(dim)                                                                           \
  template void Problem<dim>::check_stages() const;                                                \
  template void Problem<dim>::apply_loads();                                                       \
  template void Problem<dim>::show_floating_voltage();
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
