#include <thelma/base/quantity.h>
#include <thelma/output/end_of_path.h>
#include <thelma/simulation/verdict.h>
#include <thelma/strategies/path_end.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace thelma
{

template <int dim>
void Verdict<dim>::on_heating()
{
  outcome.end(EndReason::no_convergence,
              ": no stable state beyond " + as_text(model.state.theta) +
                  " K while heating: " + strategies.heating.last_failure().reason);
}

/// A path that turns back announces that, not much farther away than its last states reach back.
template <int dim>
void Verdict<dim>::on_load_steps(const std::size_t index)
{
  const LoadSteps<dim>& steps = strategies.load_steps;
  const LoadStepper& control = steps.control();
  const Ramp<dim>& ramp = strategies.ramp;
  const std::string between =
      ' ' + model.loads[index].text().between(ramp.level(index, control.accepted()),
                                              ramp.level(index, control.failed()));
  model.system.load_along(&strategies.ramp);
  const double resolution = model.loading.resolution();
  ClassifiedEnd end =
      classify_end(model.system, model.state, steps.last_failure().refusal, control.failed(),
                   control.failed() + std::max(10. * resolution, 2. * model.state.recent_span()));
  switch (end.ending) {
  case PathEnding::limit_point:
    return on_limit(index, end.limit, between);
  case PathEnding::bifurcation:
    return on_bifurcation(between, end.mode);
  case PathEnding::no_convergence:
    end_here(EndReason::no_convergence, between + ": " + steps.last_failure().reason + far_gone());
  }
}

template <int dim>
void Verdict<dim>::on_limit(const std::size_t index, const double limit, const std::string& between)
{
  const auto field = [&](const double load) {
    return model.loading.field(model.loading.target_voltage() * strategies.ramp.level(index, load));
  };
  if (index != model.loads.index("voltage"))
    return end_here(EndReason::limit_point, between);
  const LoadStepper& control = strategies.load_steps.control();
  outcome.pull_in = Bracket{field(control.accepted()), field(control.failed()), field(limit)};
  end_here(EndReason::pull_in, between);
  if (!model.loading.expects_pull_in()) {
    outcome.code = ExitCode::not_converged;
    outcome.reason += ", before the target";
  }
}

template <int dim>
void Verdict<dim>::on_bifurcation(const std::string& between, BlockVector& mode)
{
  constexpr double of_cells = 0.6; // more than in modes that the mesh resolves
  end_here(EndReason::instability, between + ": " + strategies.load_steps.last_failure().reason);
  if (mode.n_blocks() > 0) {
    outcome.reason += "; the critical mode is " + describe_mode(model.layout, mode);
    if (part_within_cells(model.layout, mode) > of_cells)
      outcome.reason += ", and alternates from cell to cell or within cells: suspect the element "
                        "and confirm with a finer mesh, or another formulation (doc/elements.md)";
    output.add_mode(scene, mode);
  }
  outcome.reason += far_gone();
}

template <int dim>
void Verdict<dim>::on_path(const StepsEnd end)
{
  std::ostringstream where;
  where << std::setprecision(8) << " at e = " << model.loading.field(model.state.voltage);
  switch (end) {
  case StepsEnd::limit_point:
    outcome.ended = EndReason::pull_in;
    outcome.reason = ending_of(EndReason::limit_point).sentence + where.str();
    return;
  case StepsEnd::observable: {
    const auto& [column, value] = *model.loading.until().begin();
    outcome.reason = "the path reached " + column + " = " + as_text(value);
    return;
  }
  case StepsEnd::no_load:
    return outcome.end(EndReason::no_load, "");
  case StepsEnd::most_steps:
    return outcome.end(EndReason::most_steps, where.str());
  case StepsEnd::exhausted:
    return end_here(EndReason::no_convergence, ": the path was lost" + where.str() + ": " +
                                                   strategies.arc_length.last_failure() +
                                                   far_gone());
  case StepsEnd::none:
  case StepsEnd::turns:
  case StepsEnd::target:
    return;
  }
}

template <int dim>
void Verdict<dim>::on_time()
{
  const TimeSteps<dim>& steps = strategies.time_steps;
  const double failed = steps.last_failure().load;
  const bool turns = model.layout.has(Field::potential) &&
                     model.state.estimated_limit() <= failed + 2. * model.state.recent_span();
  const NewtonReport& newton = steps.last_failure().newton;
  if (newton.converged || newton.refusal == Refusal::no_law || !turns)
    return end_here(EndReason::no_convergence, steps.why_exhausted());
  end_here(EndReason::pull_in, between_times(failed));
  if (!model.loading.expects_pull_in()) {
    outcome.code = ExitCode::not_converged;
    outcome.reason += ", before the end of time";
  }
}

/// The time of the last state and that beyond it which has none; in a jump the loads of both.
template <int dim>
std::string Verdict<dim>::between_times(const double failed) const
{
  const double accepted = model.state.accepted_load();
  std::ostringstream text;
  text << std::setprecision(8);
  const std::optional<LoadJump>& jump = strategies.time_steps.jump();
  if (!jump) {
    text << " between t = " << accepted << " s and " << failed << " s";
    return text.str();
  }
  text << " at t = " << jump->start << " s, where loads jump,";
  const std::vector<double> low = jump->levels(accepted), high = jump->levels(failed);
  for (std::size_t i = 0; i < model.loads.size(); ++i)
    if (model.loads[i].is_present() && low[i] != high[i])
      text << ' ' << model.loads[i].text().between(low[i], high[i]);
  return text.str();
}

/// The newest row of the curve is the last.
template <int dim>
void Verdict<dim>::end_here(const EndReason why, const std::string& details)
{
  outcome.end(why, details);
  output.set_event(ending_of(why).event);
}

/// How far a body whose end is not classified has gone, for the reason of the outcome.
template <int dim>
std::string Verdict<dim>::far_gone() const
{
  const std::string field = describe_field(scene);
  return field.empty() ? "" : "; " + field;
}

template class Verdict<2>;
template class Verdict<3>;

} // namespace thelma
