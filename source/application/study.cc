#include <thelma/application/run_command.h>
#include <thelma/application/run_scene.h>
#include <thelma/application/study.h>
#include <thelma/base/error.h>
#include <thelma/base/stop_signal.h>
#include <thelma/base/timings.h>
#include <thelma/output/curve.h>
#include <thelma/output/run_report.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <new>
#include <regex>
#include <sstream>
#include <sys/file.h>
#include <unistd.h>

namespace thelma
{
namespace
{

using dealii::Utilities::MPI::n_mpi_processes;
using dealii::Utilities::MPI::this_mpi_process;

/// A text file that no other process may lock meanwhile; the system unlocks it for one that dies.
class LockedFile
{
public:
  explicit LockedFile(std::string name)
      : name(std::move(name)), descriptor(open(this->name.c_str(), O_RDWR)),
        held(flock(descriptor, LOCK_EX) == 0)
  {
  }
  ~LockedFile() { close(descriptor); }
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;

  /// Not all network file systems know locks.
  bool is_held() const { return held; }

  std::size_t n_lines() const
  {
    std::ifstream file(name);
    return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
  }
  void append(const std::string& line) const
  {
    std::ofstream(name, std::ios::app) << line + "\n" << std::flush;
  }

private:
  std::string name;
  int descriptor;
  bool held;
};

Outcome ended_by(const std::exception& error)
{
  Outcome outcome;
  const bool lacks_memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  const bool is_input = lacks_memory || dynamic_cast<const InputError*>(&error) != nullptr;
  std::ostringstream reason;
  if (const auto* internal = dynamic_cast<const dealii::ExceptionBase*>(&error))
    internal->print_info(reason);
  else
    reason << (lacks_memory ? out_of_memory : error.what());
  outcome.end(is_input ? EndReason::bad_input : EndReason::internal_error,
              std::regex_replace(reason.str(), std::regex("\\s+"), " "));
  return outcome;
}

/// A study in a folder of a single run would mix their files; one that has fewer cases than the
/// study before it says which leave the table.
void look_into(const std::string& folder, const std::vector<Case>& cases)
{
  std::ifstream table(folder + "/study.csv");
  if (!table && std::filesystem::exists(folder + "/used.prm"))
    throw InputError("command line, --output: '" + folder +
                     "' contains a single run; choose another folder");
  std::string line;
  std::getline(table, line);
  unsigned int n_gone = 0;
  while (std::getline(table, line)) {
    const auto is_row_of = [&](const Case& one) {
      return line.find("\"" + one.name + "\"") != std::string::npos;
    };
    if (std::none_of(cases.begin(), cases.end(), is_row_of))
      ++n_gone;
  }
  if (n_gone > 0)
    std::cout << folder << ": cases of an earlier study removed from study.csv: " << n_gone
              << "; their folders are kept" << std::endl;
}

} // namespace

Study::Study(const MPI_Comm world, const CommandLine& line)
    : world(world), group(MPI_COMM_NULL), folder(line.output), cases(cases_of(line))
{
  listen_for_signals();
  const unsigned int ranks = n_mpi_processes(world), wanted = line.ranks_per_case;
  if (wanted > ranks)
    throw InputError("command line, --ranks-per-case: " + std::to_string(wanted) +
                     " ranks requested but only " + std::to_string(ranks) +
                     " available; start with mpirun -np " + std::to_string(wanted) + " or more");
  on_rank_0(world, [&]() {
    look_into(folder, cases);
    create_folder(folder);
    lock.emplace(folder);
    for (const Case& one : cases)
      create_folder(one.folder);
    RunCommand::here(line.arguments).write(folder);
    write_file(folder + "/log.txt", "");
  });
  // Ranks that are left over join the last group.
  const unsigned int number = std::min(this_mpi_process(world) / wanted, ranks / wanted - 1);
  MPI_Comm_split(world, static_cast<int>(number), 0, &group);
}

Study::~Study()
{
  // An exception may have hit this rank alone, and the others would never come here.
  if (std::uncaught_exceptions() == 0)
    MPI_Comm_free(&group);
}

ExitCode Study::run()
{
  const Stopwatch stopwatch;
  try {
    find_unfinished();
    if (this_mpi_process(world) == 0 && unfinished.size() < cases.size())
      std::cout << folder << ": " << cases.size() - unfinished.size() << " of " << cases.size()
                << " cases are already finished" << std::endl;
    for (const Case* one : unfinished)
      if (claim(*one)) {
        run_case(*one);
        if (this_mpi_process(group) == 0)
          publish(*one);
      }
  } catch (const WriteError& error) {
    std::cerr << "thelma: " << error.what() << std::endl;
    MPI_Abort(world, static_cast<int>(ExitCode::stopped));
  }
  MPI_Barrier(world);
  const ExitCode worst = conclude();
  if (this_mpi_process(world) == 0)
    std::cout << folder << "/study.csv: " << cases.size() << " cases, " << std::setprecision(3)
              << stopwatch.seconds() << " s" << std::endl;
  return worst;
}

/// Also clears the way for those that are not: what a case left that was changed or killed, but for
/// its checkpoints.
void Study::find_unfinished()
{
  std::vector<unsigned int> is_unfinished(cases.size(), 0);
  for (std::size_t c = this_mpi_process(world); c < cases.size(); c += n_mpi_processes(world)) {
    try {
      is_unfinished[c] = !is_finished(cases[c].file, cases[c].folder);
    } catch (const InputError& error) {
      is_unfinished[c] = 1; // its run says so again, in its folder
      for (const std::string& sentence : error.sentences())
        std::cerr << "thelma: " + sentence + "; the other cases are run\n" << std::flush;
    }
    if (is_unfinished[c])
      for (const char* file : {"/run.json", "/log.txt"})
        remove_file(cases[c].folder + file);
  }
  dealii::Utilities::MPI::max(is_unfinished, world, is_unfinished);
  for (std::size_t c = 0; c < cases.size(); ++c)
    if (is_unfinished[c])
      unfinished.push_back(&cases[c]);
}

bool Study::claim(const Case& one) const
{
  bool is_mine = false;
  if (this_mpi_process(group) == 0 && !stop_requested()) {
    const std::string log = one.folder + "/log.txt";
    std::FILE* const created = std::fopen(log.c_str(), "wx"); // fails if the file exists
    if (created == nullptr && errno != EEXIST)
      throw WriteError("cannot write '" + log +
                       "'; choose another --output folder or free disk space");
    is_mine = created != nullptr;
    if (is_mine)
      std::fclose(created);
  }
  return dealii::Utilities::MPI::broadcast(group, is_mine);
}

void Study::run_case(const Case& one) const
{
  const bool is_leader = this_mpi_process(group) == 0;
  std::ofstream log;
  if (is_leader)
    log.open(one.folder + "/log.txt");
  if (is_leader && !log)
    throw WriteError("cannot write '" + one.folder + "/log.txt'; free disk space");
  Outcome failure;
  try {
    run_scene(group, one.file, one.folder, log, Begin::resumed_if_same,
              arguments_for(one.file.name(), one.overrides));
    return;
  } catch (const WriteError&) {
    throw;
  } catch (const InputError& error) {
    failure = ended_by(error);
  } catch (const std::exception& error) {
    if (n_mpi_processes(group) > 1)
      throw; // the other ranks of the group may be waiting for this one
    failure = ended_by(error);
  }
  if (is_leader) {
    log << "  " << failure.reason << "\n";
    write_run_report(failure, one.file.name(), one.folder + "/run.json");
  }
}

/// Called by one rank of a group. The study's log.txt has a line for each case that has ended since
/// the start.
void Study::publish(const Case& newest)
{
  const LockedFile log(folder + "/log.txt");
  collect_outcomes();
  if (log.is_held())
    write_file(folder + "/study.csv", study_table(cases));
  const std::size_t n_ended = cases.size() - unfinished.size() + log.n_lines() + 1;
  const std::string line = "  " + std::to_string(n_ended) + " of " + std::to_string(cases.size()) +
                           "  " + newest.name + "  " + newest.outcome->summary();
  log.append(line);
  std::cout << line + "\n" << std::flush;
}

void Study::collect_outcomes()
{
  for (Case& one : cases)
    if (!one.outcome)
      one.outcome = read_run_report(one.folder + "/run.json");
}

ExitCode Study::conclude()
{
  int worst = 0;
  on_rank_0(world, [&]() {
    collect_outcomes();
    write_file(folder + "/study.csv", study_table(cases));
    const ExitCode unknown = stop_requested() ? ExitCode::stopped : ExitCode::internal_error;
    for (const Case& one : cases)
      worst = std::max(worst, static_cast<int>(one.outcome ? one.outcome->code : unknown));
  });
  return static_cast<ExitCode>(dealii::Utilities::MPI::broadcast(world, worst));
}

} // namespace thelma
