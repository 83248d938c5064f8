#include <thelma/base/formula.h>
#include <thelma/base/parameters.h>
#include <thelma/base/version.h>
#include <thelma/output/outcome.h>

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace thelma
{

void Expectations::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Expectations"});
  prm.add_parameter("Final values", values,
                    "Expected values in the last row of the curve, as `column: expression`; an "
                    "expression may contain theta, the temperature in K.",
                    Map(Anything(), Anything(), 0, 100));
  prm.add_parameter("Relative tolerance", tolerance, "Of the expected values.", Double(0.));
}

void Expectations::setup(const std::vector<std::string>& columns, const double theta)
{
  const std::string place = "section Expectations, entry 'Final values'";
  for (const auto& [column, expression] : values) {
    if (std::find(columns.begin(), columns.end(), column) == columns.end())
      throw InputError(place + ": the curve has no column '" + column +
                       "'; known: " + comma_separated(columns));
    const Formula<1> formula(place + ", " + column, expression, "theta");
    expected[column] = formula(dealii::Point<1>(theta));
  }
}

std::string Expectations::check(const Curve& curve) const
{
  for (const auto& [column, value] : expected) {
    const double found = *curve.newest(column);
    if (!(std::abs(found - value) <= tolerance * std::abs(value))) {
      std::ostringstream text;
      text.precision(8);
      text << column << " is " << found << " but " << value << " was expected (relative "
           << "tolerance " << tolerance << ")";
      return text.str();
    }
  }
  return "";
}

void write_run_report(const Outcome& outcome, const std::string& scene, const std::string& file)
{
  using nlohmann::ordered_json;
  ordered_json report;
  report["scene"] = scene;
  report["outcome"] = outcome.name;
  report["exit_code"] = static_cast<int>(outcome.code);
  report["reason"] = outcome.reason;
  report["pull_in"] = nullptr;
  if (outcome.pull_in)
    report["pull_in"] = {{"e_below", outcome.pull_in->e_below},
                         {"e_above", outcome.pull_in->e_above},
                         {"e_estimated", outcome.pull_in->e_estimated}};
  report["steps"] = outcome.steps;
  report["failed_steps"] = outcome.failed_steps;
  report["newton_iterations"] = outcome.newton_iterations;
  report["factorisations"] = outcome.factorisations;
  report["seconds"] = outcome.seconds;
  report["seconds_per_phase"] = outcome.seconds_per_phase;
  report["cells"] = outcome.cells;
  report["unknowns"] = outcome.unknowns;
  report["modelled"] = outcome.modelled;
  ordered_json values = ordered_json::object();
  for (const auto& [name, value] : outcome.final_values)
    values[name] = value;
  report["final_values"] = values;
  report["ranks"] = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  report["versions"] = {{"thelma", version},
                        {"build", build_type},
                        {"deal.II", DEAL_II_PACKAGE_VERSION},
                        {"compiler", __VERSION__}};
  write_file(file, report.dump(2) + "\n");
}

} // namespace thelma
