#include <thelma/application/cases.h>
#include <thelma/base/error.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace thelma
{
namespace
{

std::vector<std::vector<Override>> combinations(const std::vector<Sweep>& sweeps)
{
  std::vector<std::vector<Override>> result(1);
  for (const Sweep& sweep : sweeps) {
    std::vector<std::vector<Override>> longer;
    for (const auto& before : result)
      for (const std::string& value : sweep.values) {
        longer.push_back(before);
        longer.back().push_back({sweep.entry.sections, sweep.entry.entry, value});
      }
    result = longer;
  }
  return result;
}

std::string name_of(const std::vector<Override>& changes)
{
  std::string name;
  for (const Override& change : changes)
    name += (name.empty() ? "" : ",") + change.path() + "=" + change.value;
  std::replace(name.begin(), name.end(), '/', '.');
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

/// Names of the final values of all cases in the order in which they first appear.
std::vector<std::string> value_columns(const std::vector<Case>& cases)
{
  std::vector<std::string> columns;
  for (const Case& one : cases)
    if (one.outcome)
      for (const auto& [name, value] : one.outcome->final_values)
        if (std::find(columns.begin(), columns.end(), name) == columns.end())
          columns.push_back(name);
  return columns;
}

void write_row(std::ostream& table, const Case& one, const std::vector<std::string>& columns)
{
  const Outcome& outcome = *one.outcome;
  for (const Override& change : one.changes)
    table << quoted(change.value) << ',';
  table << quoted(one.name) << ',' << static_cast<int>(outcome.code) << ',' << outcome.name() << ','
        << quoted(outcome.reason) << ',';
  if (outcome.pull_in)
    table << outcome.pull_in->e_below;
  table << ',';
  if (outcome.pull_in)
    table << outcome.pull_in->e_above;
  table << ',' << outcome.seconds;
  for (const std::string& column : columns) {
    table << ',';
    for (const auto& [name, value] : outcome.final_values)
      if (name == column)
        table << value;
  }
  table << '\n';
}

} // namespace

std::vector<Case> cases_of(const CommandLine& line)
{
  std::set<std::string> given;
  for (const Override& one : line.overrides)
    given.insert(one.path());
  for (const Sweep& sweep : line.sweeps)
    if (!given.insert(sweep.entry.path()).second)
      throw InputError("command line, --sweep: '" + sweep.entry.path() +
                       "' is also given by another --sweep or --set; give it once");
  std::vector<Case> cases;
  std::set<std::string> names;
  for (const auto& changes : combinations(line.sweeps)) {
    const std::string name = name_of(changes);
    if (!names.insert(name).second)
      throw InputError("command line, --sweep: the case '" + name +
                       "' occurs twice; give every value once");
    std::vector<Override> overrides = line.overrides;
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    cases.push_back({changes, overrides, name, line.output + "/" + name,
                     ParameterFile(line.file, overrides), std::nullopt});
  }
  return cases;
}

std::string study_table(const std::vector<Case>& cases)
{
  std::ostringstream table;
  table.precision(15);
  const std::vector<std::string> columns = value_columns(cases);
  for (const Override& change : cases.front().changes)
    table << change.path() << ',';
  table << "directory,exit_code,outcome,reason,e_below,e_above,run_seconds";
  for (const std::string& column : columns)
    table << ',' << column;
  table << '\n';
  for (const Case& one : cases)
    if (one.outcome)
      write_row(table, one, columns);
  return table.str();
}

} // namespace thelma
