// The stages of a run, and what each prescribes.

#include <thelma/base/error.h>
#include <thelma/problem.h>

#include <algorithm>
#include <cmath>

namespace thelma
{

/// Whether any electrode answers to the voltage or charge of @p stage.
template <int dim>
bool Problem<dim>::drives_an_electrode(const Stage& stage) const
{
  const auto is_connected = [&](const Electrode& electrode) {
    return !electrode.floats || loading.has_stage(Stage::Kind::connect, electrode.name);
  };
  const auto answers = [&](const Electrode& electrode) {
    return stage.kind == Stage::Kind::charge
               ? electrode.charge_multiple != 0.
               : electrode.voltage_multiple != 0. && is_connected(electrode);
  };
  return std::any_of(conditions.electrodes().begin(), conditions.electrodes().end(), answers);
}

/// A connected electrode keeps its potential, so that the voltage becomes what it has.
template <int dim>
void Problem<dim>::check_change(const Stage& stage, const std::string& place) const
{
  const Electrode& electrode = conditions.electrode(stage.electrode, place);
  if (stage.kind == Stage::Kind::disconnect && electrode.touches)
    throw InputError(place + ": 'disconnect " + stage.electrode +
                     "' has no effect, as it touches another electrode; leave a gap");
  if (stage.kind != Stage::Kind::connect)
    return;
  if (electrode.voltage_multiple == 0.)
    throw InputError(place + ": the ground electrode '" + stage.electrode +
                     "' cannot be connected; connect one whose multiple of the voltage is not 0");
  if (loading.voltage(1.) == 0.)
    throw InputError(place + ": 'connect " + stage.electrode +
                     "' needs a voltage to go on with; choose the Control voltage or e");
  for (const Electrode& other : conditions.electrodes())
    if (other.name != stage.electrode && other.voltage_multiple != 0. && !other.floats &&
        !loading.has_stage(Stage::Kind::disconnect, other.name))
      throw InputError(place + ": 'connect " + stage.electrode +
                       "' makes its potential that of the voltage, and '" + other.name +
                       "' would jump to it; disconnect '" + other.name + "' before");
}

template <int dim>
void Problem<dim>::check_stages() const
{
  const std::string place = "section Loading, entry 'Stages'";
  for (const Stage& stage : loading.stages())
    if (stage.is_electric() && layout.has(Field::potential)) {
      if (stage.kind == Stage::Kind::voltage && loading.voltage(1.) == 0.)
        throw InputError(place + ": 'voltage' has no target where the Control is charge; write "
                                 "'charge', or choose the Control voltage or e");
      if (stage.level != 0. && !drives_an_electrode(stage))
        throw InputError(
            stage.kind == Stage::Kind::charge
                ? "section Electrodes, entry 'Floating': no electrode gets a part of the charge; "
                  "write `NAME: 1`"
                : "section Electrodes, entry 'Potential': no electrode gets a part of the voltage; "
                  "give one a multiple other than 0, or make all regions passive");
    } else if (!stage.is_ramp())
      check_change(stage, place);
  struct Applied {
    Stage::Kind kind;
    std::string stage, entry;
    bool is_given;
  };
  for (const Applied& one :
       {Applied{Stage::Kind::force, "force", "section Loads, entry 'Force'", dead_loads.exist()},
        Applied{Stage::Kind::pressure, "pressure", "section Loads, entry 'Pressure'",
                pressure.exist()},
        Applied{Stage::Kind::move, "move", "section Supports, entry 'Moved'", conditions.move()}}) {
    if (loading.has_stage(one.kind) && !one.is_given)
      throw InputError(place + ": '" + one.stage + "' has nothing to apply; name it in " +
                       one.entry);
    if (one.is_given && !loading.has_stage(one.kind))
      throw InputError(one.entry + ": no stage applies it; write `" + one.stage +
                       " 1` into section Loading, entry 'Stages', or remove it");
  }
}

template <int dim>
void Problem<dim>::apply_loads()
{
  for (; n_stages < loading.stages().size(); ++n_stages) {
    const Stage& stage = loading.stages()[n_stages];
    if (!resumes && !outcome.has_reached_target())
      return;
    if (!stage.is_ramp())
      change_electrode(stage);
    else if (!stage.is_electric() || layout.has(Field::potential))
      ramp(stage);
  }
  if (outcome.has_reached_target() && loading.expects_pull_in() && !layout.is_transient()) {
    outcome.reason = "the target was reached but a pull-in was expected";
    outcome.code = ExitCode::expectation_failed;
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

/// Whether there is any way to go.
template <int dim>
bool Problem<dim>::begin_ramp(const Stage& stage)
{
  const auto before = loading.stages().begin() + static_cast<std::ptrdiff_t>(n_stages);
  first_load = static_cast<double>(std::count_if(
      loading.stages().begin(), before, [](const Stage& earlier) { return earlier.is_ramp(); }));
  present = {stage.kind, levels.of(stage.kind), stage.level};
  if (stage.kind == Stage::Kind::voltage && layout.is_transient())
    present.to *= transient.initial_voltage() / loading.voltage(1.);
  return present.to != present.from;
}

template <int dim>
void Problem<dim>::ramp(const Stage& stage)
{
  Levels now = levels;
  if (!resumes && !begin_ramp(stage))
    return;
  const auto prescribe = [&](const double load) {
    now.of(stage.kind) = present.level(load);
    state.voltage = loading.voltage(now.voltage);
    state.charge = loading.charge(now.charge);
    conditions.set_motion(now.motion);
    if (dead_loads.exist())
      system.set_loads(now.force, dead_loads.nodal());
    pressure.apply(now.pressure);
    conditions.apply(state.voltage, theta_start, 1., state.x);
    if (layout.is_transient())
      set_uniform_temperature(theta);
  };
  // Without a charge, reversing the load reverses the potential.
  const auto& electrodes = conditions.electrodes();
  const bool at_rest =
      levels.voltage == 0. && levels.charge == 0. &&
      std::none_of(electrodes.begin(), electrodes.end(),
                   [](const Electrode& electrode) { return electrode.kept_charge != 0.; });
  const LoadSymmetry symmetry =
      at_rest && stage.is_electric() ? LoadSymmetry::voltage : LoadSymmetry::none;
  if (!resumes) {
    state.start();
    const double change = stage.kind == Stage::Kind::voltage ? present.to - present.from : 1.;
    stepper.start(loading.resolution() / std::abs(change));
    leave_rest(prescribe);
  }
  const bool finished = !on_arc && follow(stepper, symmetry, prescribe,
                                          [&](const double load, const NewtonReport& report) {
                                            record(load, report);
                                          });
  if (outcome.code == ExitCode::stopped)
    return;
  levels.of(stage.kind) = present.to;
  if (!finished && path_following.is_automatic())
    return follow_load(prescribe);
  if (!finished)
    explain_end(stepper, prescribe);
}

/// At a voltage so small that the body answers linearly, the tangent at rest finds in which
/// direction the path leaves. The first step can be foretold from there, and multiplies the errors
/// of both states: they are corrected on until these are small against their distance.
template <int dim>
void Problem<dim>::leave_rest(const std::function<void(double)>& prescribe)
{
  constexpr double small = 1. / 32.; // of the first step
  constexpr double error = 1e-6;     // of a residual against that of the small load
  const double load = small * stepper.step();
  prescribe(load);
  const double change = system.residual().norm;
  prescribe(0.);
  outcome.effort.add(newton.refine(system, error * change));
  state.start();
  prescribe(load);
  const NewtonReport report = newton.solve(system, true);
  outcome.effort.add(report);
  if (!report.converged)
    return state.restore();
  outcome.effort.add(newton.refine(system, error * change));
  state.accept(load);
}

/// Where nothing is driven, the voltage of the curve is that of what carries a charge.
template <int dim>
void Problem<dim>::show_floating_voltage()
{
  const std::vector<const Electrode*> live = conditions.live_electrodes();
  if (!live.empty() && live.front()->floats)
    state.voltage = potential(*live.front(), layout, state.x) / live.front()->voltage_multiple;
}

#define INSTANTIATE(dim)                                                                           \
  template bool Problem<dim>::drives_an_electrode(const Stage&) const;                             \
  template void Problem<dim>::check_change(const Stage&, const std::string&) const;                \
  template void Problem<dim>::check_stages() const;                                                \
  template void Problem<dim>::apply_loads();                                                       \
  template void Problem<dim>::show_floating_voltage();
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
