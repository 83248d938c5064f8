#include <thelma/simulation/phases.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace thelma
{

template <int dim>
bool Phases<dim>::begin()
{
  if (is_heating()) {
    strategies.ramp.start(model.loads.heated_to(1.));
    strategies.heating.start(1e-4, 1.);
    return true;
  }
  if (is_in_time()) {
    strategies.time_steps.start();
    return true;
  }
  if (stage().is_ramp())
    return begin_ramp();
  change_electrode();
  return false;
}

template <int dim>
bool Phases<dim>::begin_ramp()
{
  if (model.loads[index()].acts_on() == Field::potential && !model.layout.has(Field::potential))
    return false;
  load_before = static_cast<double>(model.loading.stages().ramps_before(phase - 1));
  const double multiple = model.layout.is_transient() ? model.loads.amplitude(index(), 0.) : 1.;
  strategies.ramp.start(index(), stage().level * multiple);
  if (!strategies.ramp.leads_anywhere())
    return false;
  const double change =
      drives_voltage() ? strategies.ramp.level(index(), 1.) - strategies.ramp.level(index(), 0.)
                       : 1.;
  strategies.load_steps.start(model.loading.resolution() / std::abs(change));
  strategies.load_steps.lead(strategies.ramp, symmetry(), strategies.follow_path());
  strategies.load_steps.leave_rest();
  return true;
}

template <int dim>
Strategy& Phases<dim>::steps()
{
  const bool turns = strategies.follow_path();
  if (is_in_time())
    return strategies.time_steps;
  if (is_heating()) {
    strategies.heating.lead(strategies.heating_path, LoadSymmetry::none, turns);
    return strategies.heating;
  }
  strategies.load_steps.lead(strategies.ramp, symmetry(), turns);
  return strategies.load_steps;
}

/// Without a charge, reversing the load reverses the potential.
template <int dim>
LoadSymmetry Phases<dim>::symmetry() const
{
  bool at_rest = model.loads[index()].acts_on() == Field::potential;
  for (std::size_t i = 0; i < model.loads.size(); ++i)
    if (model.loads[i].acts_on() == Field::potential)
      at_rest = at_rest && strategies.ramp.level(i, 0.) == 0.;
  for (const Electrode& electrode : model.conditions.electrodes())
    at_rest = at_rest && electrode.kept_charge == 0.;
  return at_rest ? LoadSymmetry::voltage : LoadSymmetry::none;
}

template <int dim>
void Phases<dim>::change_electrode()
{
  const Electrode& electrode = model.conditions.electrode(stage().electrode, "");
  const std::size_t voltage = model.loads.index("voltage");
  if (stage().kind == Stage::Kind::connect) {
    std::vector<double> levels = model.loads.levels();
    levels[voltage] = potential(electrode, model.layout, model.state.x) /
                      (electrode.voltage_multiple * model.loading.target_voltage());
    model.loads.set_levels(levels);
    model.conditions.connect(stage().electrode);
  } else {
    model.system.residual();
    const double charge = -dealii::Utilities::MPI::sum(electrode.own_sum(model.system.reactions()),
                                                       model.layout.communicator());
    model.conditions.disconnect(stage().electrode,
                                charge - electrode.charge_multiple * model.state.charge);
  }
}

template <int dim>
void Phases<dim>::follow_arc(const std::function<double()>& remainder)
{
  const LoadStepper& control =
      (is_heating() ? strategies.heating : strategies.load_steps).control();
  const bool stops = drives_voltage() && model.loading.expects_pull_in();
  strategies.arc_length.lead(
      strategies.ramp,
      {control.step(), strategies.load_steps.control().largest_step(), stops, remainder});
  if (on_arc)
    strategies.arc_length.resume();
  else
    strategies.arc_length.start();
  on_arc = true;
}

template <int dim>
void Phases<dim>::finish()
{
  if (is_heating())
    model.state.start();
  if (!is_in_time())
    model.loads.set_levels(strategies.ramp.target());
}

template class Phases<2>;
template class Phases<3>;

} // namespace thelma
