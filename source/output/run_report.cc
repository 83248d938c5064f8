#include <thelma/base/version.h>
#include <thelma/output/run_report.h>

#include <deal.II/base/config.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <limits>

namespace thelma
{

using nlohmann::ordered_json;

void write_run_report(const Outcome& outcome, const std::string& scene, const std::string& file)
{
  ordered_json report;
  report["scene"] = scene;
  report["outcome"] = outcome.name();
  report["exit_code"] = static_cast<int>(outcome.code);
  report["reason"] = outcome.reason;
  report["pull_in"] = nullptr;
  if (outcome.pull_in)
    report["pull_in"] = {{"e_below", outcome.pull_in->e_below},
                         {"e_above", outcome.pull_in->e_above},
                         {"e_estimated", outcome.pull_in->e_estimated}};
  report["steps"] = outcome.steps;
  report["failed_steps"] = outcome.failed_steps;
  report["newton_iterations"] = outcome.effort.iterations;
  report["factorisations"] = outcome.effort.factorisations;
  report["linear_iterations"] = outcome.effort.linear_iterations;
  report["seconds"] = outcome.seconds;
  report["seconds_per_phase"] = outcome.seconds_per_phase;
  report["cells"] = outcome.cells;
  report["unknowns"] = outcome.unknowns;
  report["modelled"] = outcome.modelled;
  ordered_json values = ordered_json::object();
  for (const auto& [name, value] : outcome.final_values)
    values[name] = value;
  report["final_values"] = values;
  report["ranks"] = outcome.ranks;
  report["largest_share_over_mean"] = outcome.imbalance;
  report["ghost_share"] = outcome.ghost_share;
  report["versions"] = {{"thelma", version},
                        {"build", build_type},
                        {"deal.II", DEAL_II_PACKAGE_VERSION},
                        {"compiler", __VERSION__}};
  // A path need not be UTF-8.
  write_file(file, report.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

namespace
{

std::optional<Outcome> outcome_of(const ordered_json& report)
{
  // JSON has no number for what is not finite; it is written as null.
  const auto number = [](const ordered_json& value) {
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
  };
  Outcome outcome;
  outcome.code = static_cast<ExitCode>(report.at("exit_code").get<int>());
  const std::optional<EndReason> ended = end_reason(report.at("outcome"));
  if (!ended)
    return std::nullopt; // of another version
  outcome.ended = *ended;
  outcome.reason = report.at("reason");
  if (const ordered_json& pull_in = report.at("pull_in"); !pull_in.is_null())
    outcome.pull_in = {number(pull_in.at("e_below")), number(pull_in.at("e_above")),
                       number(pull_in.at("e_estimated"))};
  outcome.steps = report.at("steps");
  outcome.effort.iterations = report.at("newton_iterations");
  outcome.seconds = report.at("seconds");
  outcome.cells = report.at("cells");
  outcome.unknowns = report.at("unknowns").get<std::map<std::string, unsigned long long>>();
  for (const auto& [name, value] : report.at("final_values").items())
    outcome.final_values.emplace_back(name, number(value));
  return outcome;
}

} // namespace

std::optional<Outcome> read_run_report(const std::string& file)
{
  std::ifstream stream(file);
  if (!stream)
    return std::nullopt;
  try {
    return outcome_of(ordered_json::parse(stream));
  } catch (const ordered_json::exception&) {
    return std::nullopt;
  }
}

std::string scene_of_report(const std::string& file)
{
  std::ifstream stream(file);
  const ordered_json report = ordered_json::parse(stream, nullptr, false);
  return report.is_object() && report.contains("scene") && report["scene"].is_string()
             ? report["scene"].get<std::string>()
             : "";
}

} // namespace thelma
