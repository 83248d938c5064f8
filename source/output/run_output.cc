#include <thelma/base/input_errors.h>
#include <thelma/base/quantity.h>
#include <thelma/base/version.h>
#include <thelma/output/run_output.h>
#include <thelma/output/run_report.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace thelma
{

namespace
{

/// Than all of the files @p inputs that there are.
bool is_younger(const std::string& file, const std::vector<std::string>& inputs)
{
  const auto end = std::filesystem::last_write_time(file);
  return std::none_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
    std::error_code unknown;
    const auto change = std::filesystem::last_write_time(input, unknown);
    return !unknown && change > end;
  });
}

} // namespace

template <int dim>
RunOutput<dim>::RunOutput(const MPI_Comm comm, const ParameterFile& file, std::string folder,
                          std::ostream& console, Timings& timings)
    : comm(comm), file_name(file.name()), folder(std::move(folder)),
      console(console, dealii::Utilities::MPI::this_mpi_process(comm) == 0), timings(timings),
      checkpoints(this->folder), observed(file)
{
}

template <int dim>
void RunOutput<dim>::declare(dealii::ParameterHandler& prm)
{
  {
    const Section section(prm, {"Output"});
    observed.declare_names(prm);
    add_quantity(prm, "Checkpoint interval", checkpoint_interval,
                 "Shortest time between two checkpoints, from which a killed run can continue; 0: "
                 "one after every step.",
                 Quantity("s", 0.));
  }
  fields.declare(prm);
  expectations.declare(prm);
  observed.declare(prm);
}

template <int dim>
void RunOutput<dim>::setup(const ObservableInput<dim>& scene, const double theta)
{
  std::vector<std::string> columns{"step", "load", "voltage_kV", "e", "theta_K"};
  if (scene.layout.is_transient())
    columns.insert(columns.begin() + 2, "time_s");
  InputErrors errors;
  observed.setup(scene, errors);
  for (const std::string& column : observed.columns())
    columns.push_back(column);
  columns.emplace_back("min_det_F");
  if (scene.system.stability.is_known())
    columns.emplace_back("unstable_directions");
  columns.emplace_back("newton_iterations");
  if (scene.system.linear.iterates())
    columns.emplace_back("linear_iterations");
  columns.emplace_back("seconds");
  curve = std::make_unique<Curve>(columns);
  std::vector<std::string> header = columns;
  header.emplace_back("event");
  observed.require_distinct(header, errors);
  errors.collect([&]() { expectations.setup(columns, theta); });
  errors.raise();
}

template <int dim>
bool RunOutput<dim>::is_finished(const std::string& parameters,
                                 const std::vector<std::string>& inputs) const
{
  const std::string report = folder + "/run.json";
  const std::optional<Outcome> outcome = read_run_report(report);
  std::stringstream used;
  used << std::ifstream(folder + "/used.prm").rdbuf();
  if (!outcome || !outcome->is_lasting() || used.str() != parameters)
    return false;
  return is_younger(report, inputs);
}

template <int dim>
void RunOutput<dim>::start(const std::string& parameters, const Outcome& outcome,
                           const double theta, const bool continued)
{
  on_rank_0(comm, [&]() {
    remove_file(folder + "/run.json"); // the report of an earlier run
    if (!continued) {
      checkpoints.remove();
      for (const std::string file : {"curve.csv", "estimate.csv"})
        remove_file(folder + "/" + file);
      FieldWriter<dim>::remove_old(folder);
    }
    write_file(folder + "/used.prm", parameters);
    if (continued && !curve->empty())
      curve->write(folder + "/curve.csv");
  });
  if (continued)
    fields.write_list(comm, folder);
  console << "Thelma " << version << ", " << file_name << " on " << outcome.ranks << " rank(s), "
          << outcome.cells << " cells\n";
  for (const std::string& line : outcome.modelled)
    console << "  " << line << "\n";
  console << "  temperature: " << theta << " K\n";
  if (continued)
    console << "  continued after " << curve->n_rows() << " steps and " << std::setprecision(3)
            << seconds_before << " s\n";
  console << std::flush;
}

template <int dim>
void RunOutput<dim>::write_checkpoint(const std::string& content)
{
  const auto timer = timings.measure("output");
  on_rank_0(comm, [&]() { checkpoints.write(content); });
  since_checkpoint = {};
}

template <int dim>
std::optional<std::string> RunOutput<dim>::read_checkpoint(const std::vector<std::string>& inputs)
{
  std::optional<std::string> content;
  on_rank_0(comm, [&]() {
    std::vector<std::string> damaged;
    if (checkpoints.has_any())
      content = checkpoints.read(damaged);
    if (content && !is_younger(checkpoints.newest_file(), inputs))
      content.reset();
    for (const std::string& file : damaged)
      console << "  the checkpoint '" << file << "' is damaged and ignored\n";
  });
  if (!dealii::Utilities::MPI::broadcast(comm, content.has_value()))
    return {};
  return dealii::Utilities::MPI::broadcast(comm, content.value_or(""));
}

template <int dim>
void RunOutput<dim>::add(const ObservableInput<dim>& scene, const PathPoint& point,
                         const NewtonReport& report)
{
  const auto timer = timings.measure("output");
  std::vector<double> row{double(curve->n_rows()), point.load, scene.state.voltage, point.e,
                          mean_temperature(scene)};
  if (scene.layout.is_transient())
    row.insert(row.begin() + 2, scene.state.time);
  for (const double value : observed.evaluate(scene))
    row.push_back(value);
  row.push_back(report.min_det_F);
  if (scene.system.stability.is_known())
    row.push_back(static_cast<double>(point.unstable_directions));
  row.push_back(report.iterations);
  if (scene.system.linear.iterates())
    row.push_back(report.linear_iterations);
  row.push_back(seconds());
  curve->add(row);
  curve->set_event(point.event);
  on_rank_0(comm, [&]() { curve->write(folder + "/curve.csv"); });
  fields.write(scene, folder, curve->n_rows() - 1, abscissa(scene, point.load), false);
  print_step(scene, point, report);
}

template <int dim>
double RunOutput<dim>::abscissa(const ObservableInput<dim>& scene, const double load)
{
  return scene.layout.is_transient() ? scene.state.time : load;
}

template <int dim>
void RunOutput<dim>::print_step(const ObservableInput<dim>& scene, const PathPoint& point,
                                const NewtonReport& report)
{
  std::ostringstream line;
  line << "  step " << std::setw(3) << curve->n_rows() - 1 << "  load " << std::fixed
       << std::setprecision(6) << point.load;
  if (scene.layout.is_transient())
    line << "  time " << scene.state.time << " s";
  line << "  e " << point.e << "  V " << std::setprecision(4) << scene.state.voltage
       << " kV  Newton " << report.iterations << std::scientific << std::setprecision(1)
       << "  residual " << report.residuals.back() << std::fixed << std::setprecision(4)
       << "  min det F " << report.min_det_F << std::defaultfloat << std::setprecision(3)
       << "  step size " << point.step_size;
  if (point.part > 0.)
    line << "  ETA " << std::setprecision(2) << seconds() * (1. - point.part) / point.part << " s";
  console << line.str() << "\n" << std::flush;
}

template <int dim>
void RunOutput<dim>::finish(const ObservableInput<dim>& scene, Outcome& outcome)
{
  outcome.steps = curve->n_rows();
  if (outcome.code == ExitCode::success) {
    const std::string complaint = expectations.check(*curve);
    if (!complaint.empty()) {
      outcome.code = ExitCode::expectation_failed;
      outcome.reason = complaint;
    }
  }
  if (!curve->empty()) {
    fields.write(scene, folder, curve->n_rows() - 1, abscissa(scene, scene.state.accepted_load()),
                 true);
    for (const std::string& column : curve->names())
      outcome.final_values.emplace_back(column, *curve->newest(column));
  }
  outcome.seconds = seconds();
  outcome.seconds_per_phase = timings.seconds();
  on_rank_0(comm, [&]() {
    if (!curve->empty())
      curve->write(folder + "/curve.csv");
    write_run_report(outcome, file_name, folder + "/run.json");
    if (outcome.is_lasting())
      checkpoints.remove();
  });
  console << "  " << outcome.summary() << "\n" << std::flush;
}

template class RunOutput<2>;
template class RunOutput<3>;

} // namespace thelma
