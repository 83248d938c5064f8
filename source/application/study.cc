#include <thelma/application/simulation.h>
#include <thelma/application/study.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

namespace thelma
{
namespace
{

/// All combinations of the swept values, the last sweep running fastest.
std::vector<std::vector<Override>> combinations(const std::vector<Sweep>& sweeps)
{
  std::vector<std::vector<Override>> cases(1);
  for (const Sweep& sweep : sweeps) {
    std::vector<std::vector<Override>> longer;
    for (const auto& before : cases)
      for (const std::string& value : sweep.values) {
        longer.push_back(before);
        longer.back().push_back({sweep.entry.sections, sweep.entry.entry, value});
      }
    cases = longer;
  }
  return cases;
}

/// A folder name such as `Temperature.Value=273`.
std::string folder_of(const std::vector<Override>& changes)
{
  std::string name;
  for (const Override& change : changes)
    name += (name.empty() ? "" : ",") + change.path() + "=" + change.value;
  std::replace(name.begin(), name.end(), '/', '.');
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

Outcome run_case(const CommandLine& line, const std::vector<Override>& changes,
                 const std::string& folder)
{
  std::vector<Override> overrides = line.overrides;
  overrides.insert(overrides.end(), changes.begin(), changes.end());
  try {
    return run_scene(MPI_COMM_WORLD, ParameterFile(line.file, overrides), folder, std::cout);
  } catch (const InputError& error) {
    Outcome outcome;
    outcome.code = ExitCode::bad_input;
    outcome.name = "bad input";
    outcome.reason = error.what();
    return outcome;
  }
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

struct Case {
  std::vector<Override> changes;
  std::string folder;
  Outcome outcome;
};

/// The final values of the first case that has any are the columns.
std::string study_table(const std::vector<Case>& cases)
{
  std::ostringstream table;
  table.precision(15);
  std::vector<std::pair<std::string, double>> columns;
  for (const Case& one : cases)
    if (columns.empty())
      columns = one.outcome.final_values;
  for (const Override& change : cases.front().changes)
    table << change.path() << ',';
  table << "directory,exit_code,outcome,reason,e_below,e_above,run_seconds";
  for (const auto& column : columns)
    table << ',' << column.first;
  table << '\n';
  for (const Case& one : cases) {
    const Outcome& outcome = one.outcome;
    for (const Override& change : one.changes)
      table << quoted(change.value) << ',';
    table << quoted(one.folder) << ',' << static_cast<int>(outcome.code) << ',' << outcome.name
          << ',' << quoted(outcome.reason) << ',';
    if (outcome.pull_in)
      table << outcome.pull_in->e_below << ',' << outcome.pull_in->e_above;
    else
      table << ',';
    table << ',' << outcome.seconds;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      table << ',';
      if (c < outcome.final_values.size())
        table << outcome.final_values[c].second;
    }
    table << '\n';
  }
  return table.str();
}

} // namespace

ExitCode run_study(const CommandLine& line)
{
  std::vector<Case> cases;
  ExitCode worst = ExitCode::success;
  for (const auto& changes : combinations(line.sweeps)) {
    const std::string folder = folder_of(changes);
    cases.push_back({changes, folder, run_case(line, changes, line.output + "/" + folder)});
    worst = std::max(worst, cases.back().outcome.code);
    on_rank_0(MPI_COMM_WORLD, [&]() {
      std::error_code ignored; // write_file says what is wrong
      std::filesystem::create_directories(line.output, ignored);
      write_file(line.output + "/study.csv", study_table(cases));
      if (cases.back().outcome.code == ExitCode::bad_input)
        std::cerr << "thelma: " << folder << ": " << cases.back().outcome.reason << std::endl;
    });
  }
  return worst;
}

} // namespace thelma
