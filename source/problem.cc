#include <thelma/base/version.h>
#include <thelma/problem.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <chrono>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <sstream>

namespace thelma
{
namespace
{

bool is_rank_0()
{
  return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}

double now()
{
  using std::chrono::duration;
  return duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

template <int dim>
Problem<dim>::Problem(const ParameterFile& file, std::string output)
    : file_name(file.name()), folder(std::move(output)), console(std::cout, is_rank_0()),
      materials(file), mesh(MPI_COMM_WORLD), system(layout, conditions, state, timings),
      predictor(layout, conditions, state)
{
  file.peek([&](dealii::ParameterHandler& choices) {
    const Section section(choices, {"Output"});
    choices.add_parameter("Observables", observed_names);
  });
  for (const std::string& name : observed_names)
    observed.emplace_back(name, observables<dim>().create(name));
  observed_names.clear(); // the declared default
  declare();
  file.read(prm);
}

template <int dim>
void Problem<dim>::declare()
{
  using namespace dealii::Patterns;
  prm.add_parameter("Dimension", dimension, "2: the x1-x3 plane in plane strain; 3: space.",
                    Integer(2, 3));
  mesh.declare(prm);
  materials.declare(prm);
  layout.declare(prm);
  system.declare(prm);
  conditions.declare(prm);
  {
    const Section section(prm, {"Temperature"});
    prm.add_parameter("Value", theta,
                      "Uniform temperature in K; where the temperature is a field, its first guess "
                      "and the temperature at which e is defined.",
                      Double(1.));
  }
  loading.declare(prm);
  stepper.declare(prm);
  {
    const Section section(prm, {"Stepping"});
    prm.add_parameter("Unstable states", unstable_states,
                      "Whether an equilibrium with unstable directions ends the run (`reject`) or "
                      "is kept, with an event in the curve (`keep`).",
                      Selection("reject|keep"));
  }
  newton.declare(prm);
  {
    const Section section(prm, {"Output"});
    prm.add_parameter("Observables", observed_names,
                      "Columns of curve.csv beside the load; known: " +
                          comma_separated(observables<dim>().names()) + ".");
  }
  fields.declare(prm);
  expectations.declare(prm);
  for (const auto& [name, observable] : observed) {
    const Section section(prm, {"Observables", name});
    observable->declare(prm);
  }
}

template <int dim>
void Problem<dim>::setup()
{
  const double start = now();
  materials.check(theta);
  {
    const auto timer = timings.measure("mesh");
    mesh.read(std::filesystem::path(file_name).parent_path().string());
  }
  layout.setup(mesh, materials);
  conditions.setup(mesh, layout);
  loading.setup(materials, theta);
  theta_start = materials.reference_temperature();
  state.theta = theta;
  state.x = layout.new_vector();
  if (layout.has(Field::temperature))
    state.x.block(layout.block(Field::temperature)) = theta_start;
  system.setup();
  predictor.setup();
  state.start();

  std::vector<std::string> columns{"step", "load", "voltage_kV", "e", "theta_K"};
  for (const auto& entry : observed) {
    entry.second->setup(scene());
    for (const std::string& column : entry.second->columns())
      columns.push_back(column);
  }
  columns.emplace_back("min_det_F");
  if (system.is_symmetric())
    columns.emplace_back("unstable_directions");
  columns.emplace_back("newton_iterations");
  columns.emplace_back("seconds");
  curve = std::make_unique<Curve>(columns);
  expectations.setup(columns, theta);

  outcome.modelled = layout.summary();
  outcome.modelled.push_back(loading.description());
  outcome.cells = mesh.triangulation().n_active_cells();
  for (const Field field : layout.fields())
    outcome.unknowns[field_name(field)] = layout.n_dofs(field);
  outcome.seconds = now() - start;
}

template <int dim>
Outcome Problem<dim>::run()
{
  const double start = now() - outcome.seconds;
  create_folder();
  console << "Thelma " << version << ", " << file_name << " on "
          << dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) << " rank(s), "
          << outcome.cells << " cells\n";
  for (const std::string& line : outcome.modelled)
    console << "  " << line << "\n";
  console << "  temperature: " << theta << " K\n" << std::flush;

  outcome.seconds = start; // until finish(): the moment the run began
  heat();
  if (outcome.code == ExitCode::success && layout.has(Field::potential))
    apply_voltage();
  finish();
  return outcome;
}

template <int dim>
void Problem<dim>::heat()
{
  Stepper steps;
  steps.start(1e-4, 1.);
  const auto prescribe = [&](const double part) {
    if (!layout.has(Field::temperature))
      state.theta = theta_start + part * (theta - theta_start);
    conditions.apply(0., theta_start, part, state.x);
  };
  NewtonReport last;
  const auto remember = [&](double, const NewtonReport& report) { last = report; };
  if (follow(steps, LoadSymmetry::none, prescribe, remember)) {
    state.start();
    record(0., last);
  } else
    outcome = failure("no convergence", "no stable state beyond " + std::to_string(state.theta) +
                                            " K while heating: " + last_failure);
}

template <int dim>
void Problem<dim>::apply_voltage()
{
  stepper.start(loading.resolution());
  const auto prescribe = [&](const double load) {
    state.voltage = loading.voltage(load);
    conditions.apply(state.voltage, theta_start, 1., state.x);
  };
  if (!follow(stepper, LoadSymmetry::voltage, prescribe,
              [&](const double load, const NewtonReport& report) { record(load, report); })) {
    prescribe(state.accepted_load());
    explain_end(stepper);
  } else if (loading.expects_pull_in()) {
    outcome = failure("target reached", "the target was reached but a pull-in was expected");
    outcome.code = ExitCode::expectation_failed;
  }
}

template <int dim>
bool Problem<dim>::follow(Stepper& steps, const LoadSymmetry symmetry,
                          const std::function<void(double)>& prescribe, const Record& on_accept)
{
  while (!steps.finished() && !steps.exhausted()) {
    const double load = steps.next();
    {
      const auto timer = timings.measure("prediction");
      predictor.predict(load, symmetry);
    }
    prescribe(load);
    NewtonReport report = solve();
    const double surprise = predictor.surprise();
    if (report.converged && surprise > 1. && !steps.finest()) {
      report.converged = false;
      report.reason = "the state found is not the continuation of the path";
    }
    outcome.newton_iterations += report.iterations;
    outcome.factorisations += report.factorisations;
    if (!report.converged) {
      ++outcome.failed_steps;
      last_failure = report.reason;
      state.restore();
      predictor.adapt(std::numeric_limits<double>::infinity());
      steps.cut_back();
      continue;
    }
    predictor.adapt(surprise);
    state.accept(load);
    steps.accept(report.iterations, state.estimated_limit());
    on_accept(load, report);
  }
  return steps.finished();
}

template <int dim>
long long Problem<dim>::unstable_directions(const NewtonReport& report) const
{
  return system.is_symmetric() ? system.unstable_directions(report.negative_pivots) : 0;
}

/// A converged state counts only if it is stable, unless the scene says otherwise.
template <int dim>
NewtonReport Problem<dim>::solve() const
{
  NewtonReport report = newton.solve(system);
  const long long unstable = unstable_directions(report);
  if (report.converged && unstable != 0 && unstable_states == "reject") {
    report.converged = false;
    report.reason = "the state found has " + std::to_string(unstable) + " unstable direction(s)";
  }
  return report;
}

template <int dim>
void Problem<dim>::explain_end(const Stepper& steps)
{
  const auto field = [&](const double load) { return loading.field(loading.voltage(load)); };
  const double limit = state.estimated_limit();
  const Bracket bracket{field(steps.accepted()), field(steps.failed()), field(limit)};
  std::ostringstream between;
  between << std::setprecision(7) << " between e = " << bracket.e_below << " and "
          << bracket.e_above;

  // At a limit point the path itself announces its end; anything else is not a pull-in.
  const bool turns_back = limit < steps.failed() + 10. * loading.resolution();
  if (!turns_back) {
    const bool unstable = last_failure.find("unstable") != std::string::npos;
    outcome = failure(unstable ? "instability" : "no convergence",
                      (unstable ? "loss of stability" : "no convergence") + between.str() + ": " +
                          last_failure);
    curve->set_event(unstable ? "bifurcation" : "no convergence");
    return;
  }
  outcome.pull_in = bracket;
  outcome.name = "pull-in";
  outcome.reason = "pull-in" + between.str();
  curve->set_event("pull-in");
  if (!loading.expects_pull_in()) {
    outcome.code = ExitCode::not_converged;
    outcome.reason += ", before the target";
  }
}

template <int dim>
void Problem<dim>::record(const double load, const NewtonReport& report)
{
  const auto timer = timings.measure("output");
  std::vector<double> row{double(curve->n_rows()), load, state.voltage,
                          loading.field(state.voltage), mean_temperature(scene())};
  for (const auto& entry : observed)
    for (const double value : entry.second->evaluate(scene()))
      row.push_back(value);
  row.push_back(report.min_det_F);
  if (system.is_symmetric())
    row.push_back(static_cast<double>(unstable_directions(report)));
  row.push_back(report.iterations);
  row.push_back(now() - outcome.seconds);
  curve->add(row);
  if (unstable_directions(report) != last_unstable)
    curve->set_event("bifurcation");
  last_unstable = unstable_directions(report);
  if (is_rank_0())
    curve->write(folder + "/curve.csv");
  fields.write(scene(), folder, curve->n_rows() - 1, load, false);
  print_step(load, report);
}

template <int dim>
void Problem<dim>::print_step(const double load, const NewtonReport& report)
{
  const double elapsed = now() - outcome.seconds;
  std::ostringstream line;
  line << "  step " << std::setw(3) << curve->n_rows() - 1 << "  load " << std::fixed
       << std::setprecision(6) << load << "  e " << loading.field(state.voltage) << "  V "
       << std::setprecision(4) << state.voltage << " kV  Newton " << report.iterations
       << std::scientific << std::setprecision(1) << "  residual " << report.residuals.back()
       << std::fixed << std::setprecision(4) << "  min det F " << report.min_det_F
       << std::defaultfloat << std::setprecision(3) << "  step size " << stepper.step();
  if (load > 0.)
    line << "  left at most " << std::fixed << std::setprecision(1) << elapsed * (1. - load) / load
         << " s";
  console << line.str() << "\n" << std::flush;
}

template <int dim>
Outcome Problem<dim>::failure(const std::string& name, const std::string& reason) const
{
  Outcome failed = outcome;
  failed.code = ExitCode::not_converged;
  failed.name = name;
  failed.reason = reason;
  return failed;
}

template <int dim>
void Problem<dim>::finish()
{
  outcome.steps = curve->n_rows();
  if (outcome.code == ExitCode::success) {
    const std::string complaint = expectations.check(*curve);
    if (!complaint.empty()) {
      outcome.code = ExitCode::expectation_failed;
      outcome.reason = complaint;
    }
  }
  if (!curve->empty())
    fields.write(scene(), folder, curve->n_rows() - 1, state.accepted_load(), true);
  outcome.seconds = now() - outcome.seconds;
  outcome.seconds_per_phase = timings.seconds();
  if (!curve->empty())
    for (const std::string& column : curve->names())
      outcome.final_values.emplace_back(column, *curve->newest(column));
  if (is_rank_0()) {
    if (!curve->empty())
      curve->write(folder + "/curve.csv");
    write_run_report(outcome, file_name, folder + "/run.json");
  }
  console << "  " << (outcome.reason.empty() ? outcome.name : outcome.reason) << "; "
          << outcome.steps << " steps, " << outcome.newton_iterations << " Newton iterations, "
          << std::setprecision(3) << outcome.seconds << " s\n"
          << std::flush;
}

template <int dim>
void Problem<dim>::create_folder() const
{
  on_rank_0([&]() {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
      throw InputError("command line, --output: cannot create the folder '" + folder + "' (" +
                       error.message() + "); choose another one");
    std::ostringstream used;
    print_parameters(used);
    write_file(folder + "/used.prm", used.str());
  });
}

template <int dim>
void Problem<dim>::print_parameters(std::ostream& stream) const
{
  prm.print_parameters(stream, dealii::ParameterHandler::Text |
                                   dealii::ParameterHandler::KeepDeclarationOrder);
}

template <int dim>
Scene<dim> Problem<dim>::scene() const
{
  return {materials, mesh, layout, conditions, system, state};
}

template class Problem<2>;
template class Problem<3>;

} // namespace thelma
