#include <thelma/assembly/rank_shares.h>
#include <thelma/base/error.h>
#include <thelma/base/stop_signal.h>
#include <thelma/simulation/checkpoint.h>
#include <thelma/simulation/simulation.h>
#include <thelma/simulation/unused_entries.h>
#include <thelma/simulation/verdict.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <sstream>
#include <utility>

namespace thelma
{

template <int dim>
Simulation<dim>::Simulation(const MPI_Comm comm, const ParameterFile& file, std::string folder,
                            std::ostream& console)
    : scene_folder(std::filesystem::path(file.name()).parent_path().string()),
      output(comm, file, std::move(folder), console, timings), model(comm, file, timings),
      strategies(model), phases(model, strategies)
{
  outcome.ranks = dealii::Utilities::MPI::n_mpi_processes(comm);
  declare();
  errors.collect([&]() { file.read(prm); });
}

template <int dim>
void Simulation<dim>::declare()
{
  prm.add_parameter("Dimension", dimension, "2: the x1-x3 plane, see Geometry; 3: space.",
                    dealii::Patterns::Integer(2, 3));
  model.declare(prm);
  strategies.declare(prm);
  output.declare(prm);
}

template <int dim>
void Simulation<dim>::setup(const std::string& picture_folder)
{
  InputErrors found;
  check(picture_folder, found);
  errors.add_unexplained(found);
  errors.raise();
  model.setup();

  outcome.modelled = model.summary();
  const auto tell = [&](const std::vector<std::string>& lines) {
    outcome.modelled.insert(outcome.modelled.end(), lines.begin(), lines.end());
  };
  if (model.layout.is_transient())
    tell(strategies.time_steps.summary());
  tell(output.remarks());
  tell(unused_entries(prm, model, strategies.follow_path()));
  outcome.cells = model.mesh.n_cells();
  outcome.imbalance = imbalance(model.layout, model.system.linear.matrix());
  outcome.ghost_share = ghost_share(model.layout);
  for (const Field field : model.layout.fields())
    outcome.unknowns[field_name(field)] = model.layout.n_dofs(field);
}

template <int dim>
void Simulation<dim>::check(const std::string& picture_folder, InputErrors& found)
{
  const auto draw = [&](const WholeMesh<dim>& mesh) {
    if (picture_folder.empty())
      return;
    try {
      create_folder(picture_folder);
      write_file(picture_folder + "/mesh.vtu", picture(mesh));
      mesh_is_drawn = true;
    } catch (const std::runtime_error&) { // nothing is wrong with the scene
    }
  };
  const bool has_amplitudes = found.collect([&]() {
    model.loads.read_amplitudes(model.layout.is_transient()
                                    ? std::optional<double>(strategies.time_steps.final_time())
                                    : std::nullopt);
    strategies.time_steps.check();
  });
  const typename Model<dim>::Parts stand = model.check(scene_folder, draw, found);
  if (!stand.layout)
    return;
  if (has_amplitudes && stand.conditions && model.layout.is_transient())
    found.collect([&]() { model.loads.check_levels(strategies.time_steps.final_time()); });
  strategies.check(stand.conditions, found);
  if (found.collect([&]() { strategies.choose_solvers(); }))
    found.collect([&]() { output.setup(observable_input(), model.theta); });
  found.collect([&]() {
    for (const auto& entry : model.loading.until())
      output.require_column(entry.first, "section Loading, entry 'Until'");
  });
}

template <int dim>
std::string Simulation<dim>::parameters() const
{
  std::ostringstream text;
  prm.print_parameters(text, dealii::ParameterHandler::PRM |
                                 dealii::ParameterHandler::KeepDeclarationOrder);
  return text.str();
}

template <int dim>
bool Simulation<dim>::is_finished() const
{
  errors.raise();
  return output.is_finished(parameters(), {model.mesh.path(scene_folder), "/proc/self/exe"});
}

template <int dim>
Outcome Simulation<dim>::run()
{
  output.start(parameters(), outcome, model.theta, resumes);
  try {
    for (; phases.remain() && outcome.has_reached_target(); phases.go_on())
      run_phase();
    if (outcome.has_reached_target() && model.loading.expects_pull_in()) {
      outcome.reason = std::string(model.layout.is_transient() ? "the end of time" : "the target") +
                       " was reached but a pull-in was expected";
      outcome.code = ExitCode::expectation_failed;
    }
  } catch (const OutOfMemory& error) {
    if (!model.state.path().empty())
      model.state.restore();
    outcome.end(EndReason::out_of_memory, error.what());
  }
  output.finish(observable_input(), outcome);
  return outcome;
}

/// Where the load alone no longer leads along a path that is to be followed, its arc does.
template <int dim>
void Simulation<dim>::run_phase()
{
  if (!std::exchange(resumes, false) && !phases.begin())
    return;
  StepsEnd end = phases.is_on_arc() ? StepsEnd::turns : follow(phases.steps());
  const bool turns = end == StepsEnd::turns;
  if (turns)
    end = follow_arc();
  if (outcome.ended != EndReason::stopped)
    end_phase(end, turns);
}

template <int dim>
StepsEnd Simulation<dim>::follow(Strategy& strategy)
{
  while (strategy.end() == StepsEnd::none) {
    if (strategy.can_pause() && should_stop())
      return StepsEnd::none;
    const StepReport step = strategy.advance();
    if (step.found())
      strategy.accept(step, *this);
    else
      strategy.cut_back(step);
    const StepsEffort spent = strategy.take_effort();
    outcome.effort.add(spent.newton);
    outcome.failed_steps += spent.failed_steps;
  }
  return strategy.end();
}

template <int dim>
StepsEnd Simulation<dim>::follow_arc()
{
  std::function<double()> remainder;
  if (!phases.is_heating())
    for (const auto& [column, value] : model.loading.until())
      remainder = [this, column = column, value = value]() {
        return output.value(observable_input(), column) - value;
      };
  phases.follow_arc(remainder);
  const StepsEnd end = follow(strategies.arc_length);
  if (outcome.ended == EndReason::stopped)
    return end;
  phases.leave_arc();
  model.state.accept(model.system.load());
  return end;
}

template <int dim>
void Simulation<dim>::end_phase(const StepsEnd end, const bool was_on_arc)
{
  const ObservableInput<dim> now = observable_input();
  Verdict<dim> verdict(model, strategies, output, outcome, now);
  if (end == StepsEnd::target) {
    phases.finish();
    if (phases.is_heating()) {
      last_heated.load = last_heated.part = 0.;
      last_heated.next_step = strategies.load_steps.control().step();
      add_row(last_heated, last_heated.unstable_directions != 0 ? "bifurcation" : "");
    }
  } else if (phases.is_heating())
    verdict.on_heating();
  else if (phases.is_in_time())
    verdict.on_time();
  else if (was_on_arc)
    verdict.on_path(end);
  else
    verdict.on_load_steps(phases.index());
}

template <int dim>
void Simulation<dim>::record(const StepReport& step)
{
  const bool on_arc = phases.is_on_arc();
  if (phases.is_heating())
    last_heated = step;
  if (on_arc)
    add_row(step, step.event.name());
  else if (!phases.is_heating())
    add_row(step, step.unstable_directions != model.state.unstable_directions ? "bifurcation" : "");
  const double e = model.loading.field(model.state.voltage);
  const bool turns = step.event.kind == PathEvent::Kind::limit_point;
  if (turns && phases.drives_voltage() && !outcome.pull_in)
    outcome.pull_in = Bracket{e, e, e};
}

template <int dim>
void Simulation<dim>::add_row(const StepReport& step, const std::string& event)
{
  State& state = model.state;
  if (!state.rates && model.layout.has_transient_temperature())
    strategies.time_steps.system().residual(); // for the reactions
  model.loads.observe(state);
  const double target = model.loading.target_voltage(), load = !state.rates ? step.load
                                                               : target == 0.
                                                                   ? 1.
                                                                   : state.voltage / target;
  output.add(observable_input(),
             {phases.first_load() + load, model.loading.field(state.voltage), step.next_step,
              step.part, step.unstable_directions, event},
             step.newton);
  if (!phases.is_on_arc())
    state.unstable_directions = step.unstable_directions;
}

template <int dim>
bool Simulation<dim>::should_stop()
{
  const MPI_Comm comm = model.layout.communicator();
  // The clocks of the ranks differ.
  const bool is_due =
      dealii::Utilities::MPI::this_mpi_process(comm) == 0 && output.checkpoint_is_due();
  const int wish = dealii::Utilities::MPI::max(stop_requested() ? 2 : is_due ? 1 : 0, comm);
  if (wish > 0)
    output.write_checkpoint(checkpoint().content());
  if (wish == 2)
    outcome.end(EndReason::stopped, "; " + output.advice());
  return wish == 2;
}

template <int dim>
bool Simulation<dim>::resume(const bool if_it_fits)
{
  const std::optional<std::string> content = output.read_checkpoint(
      if_it_fits ? std::vector<std::string>{"/proc/self/exe"} : std::vector<std::string>());
  return resumes = content && checkpoint().restore(*content, if_it_fits);
}

template <int dim>
Checkpoint<dim> Simulation<dim>::checkpoint()
{
  return {parameters(), model.mesh.path(scene_folder), model, strategies, phases, outcome, output};
}

template <int dim>
ObservableInput<dim> Simulation<dim>::observable_input()
{
  DiscreteSystem<dim>& solved = strategies.time_steps.system();
  return {model.materials, model.mesh,    model.layout, model.conditions,
          model.loads,     model.storage, solved,       model.state};
}

template class Simulation<2>;
template class Simulation<3>;

} // namespace thelma
