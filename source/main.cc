#include <thelma/application/estimate.h>
#include <thelma/application/excerpt.h>
#include <thelma/application/material_tests.h>
#include <thelma/application/run_scene.h>
#include <thelma/application/study.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/start_up.h>
#include <thelma/base/units.h>
#include <thelma/base/version.h>
#include <thelma/elements/formulation.h>
#include <thelma/output/observables/observables.h>
#include <thelma/solvers/linear_solver.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <new>
#include <sstream>

namespace
{

using namespace thelma;

void print_lists(std::ostream& out)
{
  const auto print = [&](const std::string& kind, const std::vector<Choice>& choices) {
    out << kind << "\n";
    for (const Choice& one : choices)
      out << "  " << std::left << std::setw(20) << one.name << one.meaning << "\n";
  };
  print("elastic laws (section Materials)", elastic_laws());
  print("branches (section Materials)", branch_laws());
  print("dielectric laws (section Materials)", dielectric_laws());
  print("element formulations (section Discretisation)", formulations<3>().choices());
  print("linear solvers (section Linear solver)", linear_solvers().choices());
  print("observables (section Output)", observables<3>().choices());
  out << "units\n  " << known_units() << "\n";
}

/// All that help, lists and defaults say of what the user named.
ExitCode explain(const CommandLine& line, std::ostream& out)
{
  using Action = CommandLine::Action;
  std::ostringstream lists;
  print_lists(lists);
  if (line.topic.empty()) {
    out << (line.action == Action::help   ? CommandLine::help()
            : line.action == Action::list ? lists.str()
                                          : default_parameters());
    return ExitCode::success;
  }
  const bool of_all = line.action == Action::help;
  std::string found;
  if (of_all)
    found += items_with(CommandLine::help(), line.topic);
  if (of_all || line.action == Action::list)
    found += items_with(lists.str(), line.topic);
  if (of_all || line.action == Action::defaults)
    found += entries_with(default_parameters(), line.topic);
  if (found.empty())
    throw InputError("command line: nothing is known of '" + line.topic +
                     "'; see thelma --help, thelma --list and thelma --defaults");
  out << found;
  return ExitCode::success;
}

/// Every case, also after one with problems.
ExitCode check(const CommandLine& line, std::ostream& out)
{
  InputErrors errors;
  for (const Case& one : cases_of(line))
    errors.collect([&]() {
      const std::string verdict =
          check_scene(MPI_COMM_WORLD, one.file, one.name.empty() ? line.output : one.folder);
      out << line.file << (one.name.empty() ? "" : ", " + one.name) << ": " << verdict << "\n";
    });
  errors.raise();
  return ExitCode::success;
}

/// Of a file that is no parameter file every line is wrong.
void complain(std::ostream& out, const std::vector<std::string>& sentences)
{
  constexpr std::size_t most = 20;
  for (std::size_t i = 0; i < std::min(most, sentences.size()); ++i)
    out << "thelma: " << sentences[i] << "\n";
  if (sentences.size() > most)
    out << "thelma: and " << sentences.size() - most << " more problems\n";
  out << std::flush;
}

ExitCode run(const CommandLine& line, std::ostream& out)
{
  switch (line.action) {
  case CommandLine::Action::version:
    out << "thelma " << version << "\n";
    return ExitCode::success;
  case CommandLine::Action::help:
  case CommandLine::Action::list:
  case CommandLine::Action::defaults:
    return explain(line, out);
  case CommandLine::Action::check:
    return check(line, out);
  case CommandLine::Action::material_point: {
    std::istream nothing(nullptr); // one rank answers
    answer_material_tests(line, out.rdbuf() ? std::cin : nothing, out);
    return ExitCode::success;
  }
  default:
    if (!line.sweeps.empty())
      return Study(MPI_COMM_WORLD, line).run();
    if (line.estimates)
      return run_with_estimate(MPI_COMM_WORLD, line, out).code;
    return SingleRun{line.file, line.overrides, line.output, line.arguments, line.restarts}
        .run(MPI_COMM_WORLD, out)
        .code;
  }
}

} // namespace

int main(int argc, char** argv)
{
  const Process process(argv[0]);
  const bool is_rank_0 = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  std::ostream silence(nullptr);
  try {
    const CommandLine line = CommandLine::parse({argv + 1, argv + argc});
    return process.end(static_cast<int>(run(line, is_rank_0 ? std::cout : silence)));
  } catch (const WriteError& error) {
    (is_rank_0 ? std::cerr : silence) << "thelma: " << error.what() << std::endl;
    return process.end(static_cast<int>(ExitCode::stopped));
  } catch (const InputError& error) {
    complain(is_rank_0 ? std::cerr : silence, error.sentences());
    return process.end(static_cast<int>(ExitCode::bad_input));
  } catch (const std::bad_alloc&) {
    std::cerr << "thelma: " << out_of_memory << std::endl;
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(ExitCode::bad_input));
  } catch (const dealii::ExceptionBase& error) {
    std::cerr << "thelma: internal error, please report it: ";
    error.print_info(std::cerr);
  } catch (const std::exception& error) {
    std::cerr << "thelma: internal error, please report it: " << error.what() << std::endl;
  }
  // The other ranks may be waiting in a message.
  MPI_Abort(MPI_COMM_WORLD, static_cast<int>(ExitCode::internal_error));
}
