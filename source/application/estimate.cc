#include <thelma/application/estimate.h>
#include <thelma/application/run_command.h>
#include <thelma/application/simulation.h>
#include <thelma/output/checkpoints.h>
#include <thelma/output/curve.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace thelma
{
namespace
{

/// Columns that a finer mesh does not make more exact.
bool is_bookkeeping(const std::string& column)
{
  static const std::vector<std::string> names{"step",
                                              "load",
                                              "time_s",
                                              "e",
                                              "voltage_kV",
                                              "theta_K",
                                              "unstable_directions",
                                              "newton_iterations",
                                              "linear_iterations",
                                              "seconds"};
  return std::find(names.begin(), names.end(), column) != names.end();
}

std::string table(const std::vector<Estimate>& estimates)
{
  std::ostringstream text;
  text << "quantity,value,error_estimate\n" << std::setprecision(15);
  for (const Estimate& one : estimates)
    text << one.name << ',' << one.value << ',' << one.error << '\n';
  return text.str();
}

void print(const std::vector<Estimate>& estimates, std::ostream& console)
{
  console << "  error of the mesh, estimated from one twice as fine:\n";
  for (const Estimate& one : estimates) {
    console << "    " << std::left << std::setw(24) << one.name << std::right << std::setw(15)
            << std::setprecision(8) << one.value << "  +- " << std::setprecision(2) << one.error;
    if (std::abs(one.value) > one.error)
      console << "  (" << 100. * one.error / std::abs(one.value) << " %)";
    console << "\n";
  }
  console << std::flush;
}

} // namespace

std::vector<Estimate> compare(const Outcome& given, const Outcome& finer, const double factor)
{
  if (given.pull_in.has_value() != finer.pull_in.has_value())
    return {};
  if (given.pull_in) {
    const auto middle = [](const Bracket& b) { return (b.e_below + b.e_above) / 2.; };
    const double width = given.pull_in->e_above - given.pull_in->e_below;
    return {{"pull_in_e", middle(*given.pull_in),
             factor * std::abs(middle(*finer.pull_in) - middle(*given.pull_in)) + width / 2.}};
  }
  std::vector<Estimate> estimates;
  for (const auto& [name, value] : given.final_values)
    for (const auto& [other, finer_value] : finer.final_values)
      if (name == other && !is_bookkeeping(name))
        estimates.push_back({name, value, factor * std::abs(finer_value - value)});
  return estimates;
}

Outcome run_with_estimate(const MPI_Comm comm, const CommandLine& line, std::ostream& console)
{
  const SingleRun first{line.file, line.overrides, line.output, line.arguments, line.restarts};
  unsigned int refinements = 0, degree = 1;
  first.scene().peek([&](dealii::ParameterHandler& prm) {
    {
      const Section section(prm, {"Mesh"});
      prm.add_parameter("Refinements", refinements);
    }
    const Section section(prm, {"Discretisation"});
    prm.add_parameter("Degree", degree);
  });
  const bool was_finished = first.earlier_end().has_value();
  const std::string finer = first.folder + "/finer";
  if (!was_finished) // whatever is there belongs to another run
    on_rank_0(comm, [&]() {
      Checkpoints(finer).remove();
      remove_file(finer + "/run.json");
    });
  Outcome given = first.run(comm, console);
  if (given.code == ExitCode::not_converged || given.code == ExitCode::stopped)
    return given;

  SingleRun second = first;
  second.overrides.push_back({{"Mesh"}, "Refinements", std::to_string(refinements + 1)});
  second.folder = finer;
  second.arguments = arguments_for(second.file, second.overrides);
  second.restarts = was_finished;
  console << "\n";
  Outcome check = second.run(comm, console);
  if (check.code == ExitCode::stopped)
    return check;
  const double factor = 1. / (1. - std::pow(0.5, degree));
  const std::vector<Estimate> estimates = compare(given, check, factor);
  if (estimates.empty() || check.code == ExitCode::not_converged) {
    console << "  no error estimate: the finer mesh ended differently\n" << std::flush;
    return given;
  }
  print(estimates, console);
  on_rank_0(comm, [&]() { write_file(first.folder + "/estimate.csv", table(estimates)); });
  return given;
}

} // namespace thelma
