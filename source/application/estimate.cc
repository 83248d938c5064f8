#include <thelma/application/convergence.h>
#include <thelma/application/estimate.h>
#include <thelma/application/run_command.h>
#include <thelma/application/run_scene.h>
#include <thelma/application/time_refinement.h>
#include <thelma/output/checkpoints.h>
#include <thelma/output/curve.h>
#include <thelma/strategies/time_schemes.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace thelma
{
namespace
{

/// A number of the report and how far it lies from that of an infinitely fine mesh and infinitely
/// short steps, probably.
struct Estimate {
  Result result;
  Convergence mesh, time;

  bool has_limit() const { return mesh.has_limit; }

  /// Errors of opposite sign are not added.
  double error() const
  {
    return result.uncertainty + std::abs(mesh.way + time.way) + mesh.doubt + time.doubt;
  }
};

/// What a scene says that matters here.
struct Entries {
  unsigned int refinements = 0, degree = 1, dimension = 3;
  double newton_tolerance = 1e-10;
  std::string temperature, analysis, scheme = time_schemes().front().name;

  explicit Entries(const ParameterFile& scene)
  {
    scene.peek([&](dealii::ParameterHandler& prm) {
      prm.add_parameter("Dimension", dimension);
      const auto add = [&](const std::string& section, const std::string& entry, auto& value) {
        const Section place(prm, {section});
        prm.add_parameter(entry, value);
      };
      add("Mesh", "Refinements", refinements);
      add("Discretisation", "Degree", degree);
      add("Temperature", "Model", temperature);
      add("Time", "Analysis", analysis);
      add("Time", "Scheme", scheme);
      add("Newton", "Tolerance", newton_tolerance);
    });
  }
  bool is_transient() const { return temperature == "transient" || analysis == "transient"; }
};

std::string table(const std::vector<Estimate>& estimates)
{
  std::ostringstream text;
  text << "quantity,value,error_estimate,mesh_error,time_error,remark\n" << std::setprecision(15);
  for (const Estimate& one : estimates) {
    text << one.result.name << ',' << one.result.value << ',';
    if (one.has_limit())
      text << one.error() << ',' << one.mesh.error() << ',' << one.time.error() << ",\n";
    else
      text << "nan,nan," << one.time.error() << ",no limit\n";
  }
  return text.str();
}

void print(const std::vector<Estimate>& estimates, const bool in_time, std::ostream& console)
{
  for (const Estimate& one : estimates) {
    const double value = one.result.value;
    console << "    " << std::left << std::setw(32) << one.result.name << std::right
            << std::setw(15) << std::setprecision(8) << value << std::setprecision(2);
    if (!one.has_limit())
      console << "  no limit: the differences between these meshes do not decrease";
    else
      console << "  +- " << one.error();
    if (one.has_limit() && std::abs(value) > one.error())
      console << "  (" << 100. * one.error() / std::abs(value) << " %)";
    if (one.has_limit() && in_time)
      console << "  mesh " << one.mesh.error() << ", time " << one.time.error();
    console << "\n";
  }
  console << std::flush;
}

/// Runs the scene again and again, in folders within that of the first.
class Estimation
{
public:
  Estimation(const MPI_Comm comm, SingleRun first, std::ostream& console)
      : comm(comm), first(std::move(first)), scene(this->first.scene()), console(console),
        was_finished(this->first.earlier_end().has_value())
  {
  }

  Outcome run();

private:
  bool repeat(Series& series, const std::string& name, const std::string& title,
              const std::vector<Override>& changes);
  bool refine(const std::vector<Override>& steps);
  bool shorten(const std::vector<double>& times);
  Override refinements(int more) const;
  Convergence in(const Series& series, std::size_t number) const;
  void conclude() const;

  MPI_Comm comm;
  SingleRun first;
  Entries scene;
  std::ostream& console;
  bool was_finished, was_stopped = false;
  Outcome given;
  Series meshes, steps;
};

/// Run the scene with @p changes in the folder @p name and add it to the @p series: at its end, or
/// at the beginning if it is coarser than what there is. Whether its numbers can be compared.
bool Estimation::repeat(Series& series, const std::string& name, const std::string& title,
                        const std::vector<Override>& changes)
{
  SingleRun again = first;
  again.folder = first.folder + "/" + name;
  again.overrides.insert(again.overrides.end(), changes.begin(), changes.end());
  again.arguments = arguments_for(again.file, again.overrides);
  again.restarts = was_finished;
  if (!was_finished) // whatever is there belongs to another run
    on_rank_0(comm, [&]() {
      Checkpoints(again.folder).remove();
      for (const char* file : {"/run.json", "/used.prm"})
        remove_file(again.folder + file);
    });
  console << "\nrepeated " << title << "\n";
  const Outcome found = again.run(comm, console);
  was_stopped = found.ended == EndReason::stopped;
  if (was_stopped)
    return false;
  const std::string problem = disagreement(given, found);
  const std::string& remark = problem.empty() ? doubt(given, found) : problem;
  if (!remark.empty())
    console << "  the run " << title << " " << remark << "\n";
  if (!problem.empty())
    return false;
  series.runs.insert(name == "coarser" ? series.runs.begin() : series.runs.end(), found);
  series.given = name == "coarser" ? 1 : series.given;
  return true;
}

Override Estimation::refinements(const int more) const
{
  return {{"Mesh"}, "Refinements", std::to_string(static_cast<int>(scene.refinements) + more)};
}

/// The meshes to compare: the given one, that of half its cells' size, and one more, from which the
/// order is measured. Whether there are two at least.
bool Estimation::refine(const std::vector<Override>& same_steps)
{
  constexpr double most_in_plane = 1.5e5, most_in_space = 4e4; // unknowns
  double unknowns = 0.;
  for (const auto& field : given.unknowns)
    unknowns += static_cast<double>(field.second);
  const bool affordable = unknowns * std::pow(4., scene.dimension) <
                          (scene.dimension == 2 ? most_in_plane : most_in_space);
  const auto on_mesh = [&](const int more) {
    std::vector<Override> changes = same_steps;
    changes.push_back(refinements(more));
    return changes;
  };
  meshes = {{given}, 0, 2. * scene.degree};
  if (!repeat(meshes, "finer", "with cells of half the size", on_mesh(1)))
    return false;
  if (affordable)
    repeat(meshes, "finest", "with cells of a quarter of the size", on_mesh(2));
  else if (scene.refinements > 0)
    repeat(meshes, "coarser", "with cells of twice the size", on_mesh(-1));
  return !was_stopped;
}

/// The same of time steps.
bool Estimation::shorten(const std::vector<double>& times)
{
  steps = {{given}, 0, double(time_scheme(scene.scheme).order)};
  if (repeat(steps, "half_steps", "with steps of half the length", steps_in_parts(times, 2)))
    repeat(steps, "quarter_steps", "with steps of a quarter of the length",
           steps_in_parts(times, 4));
  return !was_stopped && steps.runs.size() > 1;
}

/// Of the result of this @p number.
Convergence Estimation::in(const Series& series, const std::size_t number) const
{
  if (series.runs.empty())
    return {};
  std::vector<double> values;
  double uncertainty = 0.;
  for (const Outcome& one : series.runs) {
    const Result result = results(one, scene.newton_tolerance).at(number);
    values.push_back(result.value);
    uncertainty = std::max(uncertainty, result.uncertainty);
  }
  return convergence(values, series.given, series.highest_order, 2. * uncertainty);
}

void Estimation::conclude() const
{
  const std::vector<Result> found = results(given, scene.newton_tolerance);
  std::vector<Estimate> estimates;
  for (std::size_t n = 0; n < found.size(); ++n) {
    estimates.push_back({found[n], in(meshes, n), in(steps, n)});
    estimates.back().time.has_limit = true; // steps can always be shorter
  }
  console << "\n  errors, estimated from meshes of";
  for (const Outcome& one : meshes.runs)
    console << (&one == &meshes.runs.front() ? " " : ", ") << one.cells;
  console << " cells";
  if (!steps.runs.empty())
    console << " and from steps of 1" << (steps.runs.size() == 2 ? ", 1/2" : ", 1/2, 1/4")
            << " of their length";
  console << ":\n";
  print(estimates, !steps.runs.empty(), console);
  if (meshes.runs.size() == 2)
    console << "  the order of convergence was not measured (a third mesh is used if it has few "
               "unknowns, or if Mesh/Refinements allows cells of twice the size): errors are three "
               "times the difference between the two meshes\n";
  on_rank_0(comm, [&]() { write_file(first.folder + "/estimate.csv", table(estimates)); });
}

Outcome Estimation::run()
{
  given = first.run(comm, console);
  if (given.code == ExitCode::not_converged || given.code == ExitCode::stopped)
    return given;
  const std::vector<double> times =
      scene.is_transient() ? step_times(comm, first.folder) : std::vector<double>();
  const std::vector<Override> same_steps =
      times.empty() ? std::vector<Override>() : steps_in_parts(times, 1);
  const bool done = refine(same_steps) && (times.empty() || shorten(times));
  Outcome stopped = given;
  stopped.code = ExitCode::stopped;
  if (was_stopped)
    return stopped;
  if (done)
    conclude();
  else
    console << "  no error estimate, because there is nothing to compare\n" << std::flush;
  return given;
}

} // namespace

Outcome run_with_estimate(const MPI_Comm comm, const CommandLine& line, std::ostream& console)
{
  return Estimation(comm, {line.file, line.overrides, line.output, line.arguments, line.restarts},
                    console)
      .run();
}

} // namespace thelma
