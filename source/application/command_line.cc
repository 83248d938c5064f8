#include <thelma/application/command_line.h>
#include <thelma/base/error.h>

#include <deal.II/base/utilities.h>

#include <filesystem>

namespace thelma
{
namespace
{

Sweep parse_sweep(const std::string& text)
{
  Sweep sweep;
  sweep.entry = Override::parse(text);
  sweep.values = dealii::Utilities::split_string_list(sweep.entry.value, ',');
  if (sweep.values.empty())
    throw InputError("command line, --sweep: '" + text +
                     "' has no values; write Section/Entry=v1,v2,...");
  return sweep;
}

} // namespace

CommandLine CommandLine::parse(const std::vector<std::string>& arguments)
{
  CommandLine line;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const auto value = [&]() -> const std::string& {
      if (++i == arguments.size())
        throw InputError("command line: " + word + " needs a value; see thelma --help");
      return arguments[i];
    };
    if (word == "--set")
      line.overrides.push_back(Override::parse(value()));
    else if (word == "--sweep")
      line.sweeps.push_back(parse_sweep(value()));
    else if (word == "--output")
      line.output = value();
    else if (word == "--check")
      line.action = Action::check;
    else if (word == "--list")
      line.action = Action::list;
    else if (word == "--defaults")
      line.action = Action::defaults;
    else if (word == "--version")
      line.action = Action::version;
    else if (word == "--help" || word == "-h")
      line.action = Action::help;
    else if (word.rfind("-", 0) == 0)
      throw InputError("command line: unknown option '" + word +
                       "'; known: --set, --sweep, --output, --check, --list, --defaults, "
                       "--version, --help");
    else if (!line.file.empty())
      throw InputError("command line: two parameter files, '" + line.file + "' and '" + word +
                       "'; give one");
    else
      line.file = word;
  }
  const bool needs_file = line.action == Action::run || line.action == Action::check;
  if (needs_file && line.file.empty())
    throw InputError("command line: no parameter file; write thelma FILE.prm or see thelma --help");
  if (line.output.empty())
    line.output = "output/" + std::filesystem::path(line.file).stem().string();
  return line;
}

std::string CommandLine::help()
{
  return R"(thelma [options] FILE.prm
Simulates dielectric elastomer actuators: finite deformation, electric field, temperature.

  --set "Section/Entry=value"        override an entry; repeatable
  --sweep "Section/Entry=v1,v2,..."  one run per value; repeatable, all combinations
  --output DIR                       where results go (default output/<name of FILE>)
  --check                            read the scene, build everything, run nothing
  --list                             known laws, formulations, solvers and observables
  --defaults                         print every entry with its default, unit and meaning
  --version, --help

Examples
  thelma prm/planar_actuator.prm
  mpirun -np 2 thelma prm/planar_actuator.prm --set "Temperature/Value=353" --output hot
  thelma prm/planar_actuator.prm --sweep "Temperature/Value=273,293,313,333,353"

Exit codes
  0  done, and what the file expects came true
  1  bad input: one sentence says which file, section, entry and value, and the remedy
  2  an expectation of the file failed
  3  no convergence or an unexpected instability; partial results are kept
)";
}

} // namespace thelma
