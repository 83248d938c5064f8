#include <thelma/application/command_line.h>
#include <thelma/application/run_command.h>
#include <thelma/base/error.h>
#include <thelma/base/parameters.h>

#include <deal.II/base/utilities.h>

#include <filesystem>
#include <fstream>

namespace thelma
{
namespace
{

/// Without the quotes that a shell would take away.
std::string unquoted(const std::string& text)
{
  const bool is_quoted = text.size() > 1 && text.front() == text.back() &&
                         (text.front() == '"' || text.front() == '\'');
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

/// The arguments in @p file, one to a line: an option with its value, or a parameter file, which is
/// looked up from the working directory, then from this file. Lines that start with # are comments.
std::vector<std::string> read_arguments(const std::string& file)
{
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file))
    throw InputError("command line: cannot read the study '" + file +
                     "'; write @ and the path of an existing file");
  const std::string folder = std::filesystem::path(file).parent_path().string();
  std::vector<std::string> arguments;
  for (std::string line; std::getline(stream, line);) {
    line = dealii::Utilities::trim(line);
    if (line.empty() || line[0] == '#')
      continue;
    if (line[0] != '-') {
      arguments.push_back(located(line, folder));
      continue;
    }
    const std::size_t blank = line.find(' ');
    arguments.push_back(line.substr(0, blank));
    if (blank != std::string::npos)
      arguments.push_back(unquoted(dealii::Utilities::trim(line.substr(blank))));
  }
  return arguments;
}

std::vector<std::string> expanded(const std::vector<std::string>& arguments)
{
  std::vector<std::string> result;
  for (const std::string& word : arguments)
    if (word[0] == '@')
      for (const std::string& inner : read_arguments(word.substr(1)))
        result.push_back(inner);
    else
      result.push_back(word);
  return result;
}

unsigned int parse_ranks_per_case(const std::string& text)
{
  const bool is_number =
      text.size() < 7 && text.find_first_not_of("0123456789") == std::string::npos;
  const unsigned int ranks = is_number && !text.empty() ? std::stoul(text) : 0;
  if (ranks == 0)
    throw InputError("command line, --ranks-per-case: '" + text +
                     "' is not a number of ranks; write 1, 2, ...");
  return ranks;
}

Sweep parse_sweep(const std::string& text)
{
  Sweep sweep;
  sweep.entry = Override::parse(text);
  const bool has_commas = sweep.entry.value.find(';') != std::string::npos; // in the values
  sweep.values = dealii::Utilities::split_string_list(sweep.entry.value, has_commas ? ';' : ',');
  if (sweep.values.empty())
    throw InputError("command line, --sweep: '" + text +
                     "' has no values; write Section/Entry=v1,v2,...");
  return sweep;
}

/// What was started into @p folder once, from where it was started.
CommandLine restarted(const std::string& folder)
{
  std::error_code invalid; // then there is no such folder
  const std::string there = std::filesystem::absolute(folder, invalid).string();
  const RunCommand command = RunCommand::read(there);
  std::error_code gone; // then the files named from there are complained about
  std::filesystem::current_path(command.directory, gone);
  CommandLine line = CommandLine::parse(command.arguments);
  line.output = there;
  line.restarts = true;
  return line;
}

void require_consistent(const CommandLine& line)
{
  using Action = CommandLine::Action;
  const bool needs_file = line.action == Action::run || line.action == Action::check ||
                          line.action == Action::material_point;
  if (needs_file && line.file.empty())
    throw InputError("command line: no parameter file; write thelma FILE.prm or see thelma --help");
  if (line.estimates && !line.sweeps.empty())
    throw InputError("command line: --estimate is for a single run; leave out --sweep, or sweep "
                     "over Mesh/Refinements");
  if (line.ranks_per_case > 1 && line.sweeps.empty())
    throw InputError("command line: --ranks-per-case is for a study, a single run uses all ranks; "
                     "leave it out, or add --sweep");
}

const std::vector<std::string> known_options{
    "--set",   "--sweep",          "--ranks-per-case", "--output",   "--estimate", "--restart",
    "--check", "--material-point", "--list",           "--defaults", "--version",  "--help"};

} // namespace

CommandLine CommandLine::parse(const std::vector<std::string>& given)
{
  const std::vector<std::string> arguments = expanded(given);
  if (arguments.size() == 2 && arguments.front() == "--restart")
    return restarted(arguments.back());
  CommandLine line;
  line.arguments = arguments;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const auto value = [&]() -> const std::string& {
      if (++i == arguments.size())
        throw InputError("command line: " + word + " needs a value; see thelma --help");
      return arguments[i];
    };
    const auto show = [&](const Action action) {
      line.action = action;
      if (i + 1 < arguments.size() && arguments[i + 1].rfind('-', 0) != 0)
        line.topic = arguments[++i];
    };
    if (word == "--set")
      line.overrides.push_back(Override::parse(value()));
    else if (word == "--sweep")
      line.sweeps.push_back(parse_sweep(value()));
    else if (word == "--ranks-per-case")
      line.ranks_per_case = parse_ranks_per_case(value());
    else if (word == "--output") {
      line.output = value();
      if (line.output.empty())
        throw InputError("command line, --output: it is empty; give a folder for the results");
    } else if (word == "--restart")
      throw InputError(
          "command line: --restart DIR takes no other arguments; the scene and options "
          "of the run are read from the folder");
    else if (word == "--estimate")
      line.estimates = true;
    else if (word == "--check" || word == "--material-point")
      line.action = word == "--check" ? Action::check : Action::material_point;
    else if (word == "--list")
      show(Action::list);
    else if (word == "--defaults")
      show(Action::defaults);
    else if (word == "--version")
      line.action = Action::version;
    else if (word == "--help" || word == "-h")
      show(Action::help);
    else if (word.rfind('-', 0) == 0)
      throw InputError("command line: unknown option '" + word + "'" +
                       did_you_mean(word, known_options));
    else if (!line.file.empty())
      throw InputError("command line: two parameter files, '" + line.file + "' and '" + word +
                       "'; give one");
    else
      line.file = word;
  }
  require_consistent(line);
  if (line.output.empty())
    line.output = "output/" + std::filesystem::path(line.file).stem().string();
  return line;
}

std::string CommandLine::help()
{
  return R"(thelma [options] FILE.prm
thelma @STUDY                        read the options and the file from the lines of STUDY
thelma --restart DIR                 continue the run or the study in DIR
Simulates dielectric elastomer actuators: finite deformation, electric field, temperature.

  --set "Section/Entry=value"        override an entry; repeatable
  --sweep "Section/Entry=v1,v2,..."  one run per value; repeatable, all combinations; write
                                     v1; v2; ... if the values contain commas
  --ranks-per-case N                 ranks per run of a sweep (default 1); as many runs as
                                     possible run in parallel
  --output DIR                       folder for the results (default output/<name of FILE>)
  --restart DIR                      continue what is in DIR; no other arguments
  --estimate                         repeat the run on finer meshes and, for transient scenes, with
                                     shorter steps; print the error of every number (estimate.csv)
  --check                            report all errors in the scene without running it, and write
                                     the mesh to the output folder (mesh.vtu: regions, surfaces,
                                     bodies, shape quality of the cells)
  --material-point                   answer requests on standard input for stresses of homogeneous
                                     tests of the scene's materials (doc/fitting.md)
  --list [WORD]                      list laws, formulations, solvers, observables and units with
                                     their descriptions, or those that contain WORD
  --defaults [SECTION]               print every entry with its default, unit and description, or
                                     those of a section or with that word in their name
  --help [WORD], -h, --version       with WORD, everything about it

A sweep writes a folder per run and study.csv with a row per run. When restarted, it runs only what
is not finished or has changed.

A run writes a checkpoint every minute (entry Output/Checkpoint interval), and when it is stopped by
Ctrl-C, SIGTERM, or SIGUSR1 to mpirun. After that, kill -9 or a full disk, --restart continues from
the newest checkpoint, on any number of ranks; without one it starts from the beginning.

Examples
  thelma prm/planar_actuator.prm
  mpirun -np 2 thelma prm/planar_actuator.prm --set "Temperature/Value=353" --output hot
  mpirun -np 2 thelma prm/planar_actuator.prm --sweep "Temperature/Value=273,293,313,333,353"
  thelma prm/bending_actuator_plane.prm --estimate
  mpirun -np 2 thelma @prm/studies/bending_actuator.study
  mpirun -np 2 thelma --restart output/bending_actuator

Exit codes
  0  finished, and all expectations in the file are met
  1  input error: one message per error with file, line, section, entry, value and remedy
  2  an expectation in the file is not met
  3  no convergence or an unexpected instability; partial results are kept
  4  stopped by a signal or because memory or disk is full; continue with --restart
  70 internal error
The exit code of a sweep is the largest of its runs.
)";
}

} // namespace thelma
