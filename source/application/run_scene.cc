#include <thelma/application/run_command.h>
#include <thelma/application/run_scene.h>
#include <thelma/base/error.h>
#include <thelma/base/stop_signal.h>
#include <thelma/output/checkpoints.h>
#include <thelma/output/curve.h>
#include <thelma/output/folder_lock.h>
#include <thelma/output/run_report.h>
#include <thelma/simulation/simulation.h>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>

namespace thelma
{
namespace
{

unsigned int dimension_of(const ParameterFile& file)
{
  unsigned int dim = 3;
  file.peek([&](dealii::ParameterHandler& prm) {
    prm.add_parameter("Dimension", dim, "", dealii::Patterns::Integer(2, 3));
  });
  return dim;
}

/// Let @p action use the simulation of the file; errors in a section name the file.
template <typename Action>
auto with_simulation(const MPI_Comm comm, const ParameterFile& file, const std::string& folder,
                     std::ostream& console, const Action& action)
{
  try {
    if (dimension_of(file) == 2)
      return action(*std::make_unique<Simulation<2>>(comm, file, folder, console));
    return action(*std::make_unique<Simulation<3>>(comm, file, folder, console));
  } catch (const InputError& error) {
    std::vector<std::string> sentences = error.sentences();
    for (std::string& sentence : sentences)
      sentence = file.located(sentence);
    throw InputError(sentences);
  }
}

/// Called by every rank. A study's table would hide that one of its cases is gone.
void require_no_study(const MPI_Comm comm, const std::string& folder)
{
  on_rank_0(comm, [&]() {
    if (std::filesystem::exists(folder + "/study.csv"))
      throw InputError("command line, --output: '" + folder +
                       "' contains a study; choose another folder");
  });
}

/// What a run into @p folder takes the place of, for the user: nothing, if that was the same scene.
std::string replaced(const std::string& folder, const std::string& scene)
{
  const std::string earlier = scene_of_report(folder + "/run.json");
  return earlier.empty() || earlier == scene
             ? ""
             : "  the results of " + earlier + " in " + folder + " are replaced\n";
}

std::ostream& silence()
{
  static std::ostream nowhere(nullptr);
  return nowhere;
}

} // namespace

Outcome run_scene(const MPI_Comm comm, const ParameterFile& file, const std::string& folder,
                  std::ostream& console, const Begin begin,
                  const std::vector<std::string>& arguments)
{
  return with_simulation(comm, file, folder, console, [&](auto& simulation) {
    simulation.setup();
    if (begin == Begin::anew)
      console << replaced(folder, file.name());
    listen_for_signals(); // before, there is nothing to keep, and a stop need not wait
    std::optional<FolderLock> lock;
    on_rank_0(comm, [&]() {
      create_folder(folder);
      lock.emplace(folder);
    });
    const bool resumed = begin != Begin::anew && simulation.resume(begin == Begin::resumed_if_same);
    if (!resumed)
      on_rank_0(comm, [&]() { RunCommand::here(arguments).write(folder); });
    return simulation.run();
  });
}

ParameterFile SingleRun::scene() const
{
  std::ifstream used(folder + "/used.prm");
  std::ostringstream text;
  if (restarts && used && text << used.rdbuf())
    return ParameterFile::from_text(text.str(), file, folder + "/used.prm");
  return ParameterFile(file, overrides);
}

std::optional<Outcome> SingleRun::earlier_end() const
{
  if (!restarts)
    return std::nullopt;
  const std::optional<Outcome> known = read_run_report(folder + "/run.json");
  return known && known->is_lasting() ? known : std::nullopt;
}

Outcome SingleRun::run(const MPI_Comm comm, std::ostream& console) const
{
  const std::optional<Outcome> known = earlier_end();
  if (!known) {
    if (!restarts)
      require_no_study(comm, folder);
    return run_scene(comm, scene(), folder, console, restarts ? Begin::resumed : Begin::anew,
                     arguments);
  }
  on_rank_0(comm, [&]() { Checkpoints(folder).remove(); }); // if killed just before that
  console << folder << " is finished: " << known->summary() << "\n";
  return *known;
}

bool is_finished(const ParameterFile& file, const std::string& folder)
{
  return with_simulation(MPI_COMM_SELF, file, folder, silence(),
                         [](const auto& simulation) { return simulation.is_finished(); });
}

std::string check_scene(const MPI_Comm comm, const ParameterFile& file, const std::string& folder)
{
  return with_simulation(comm, file, "", silence(), [&](auto& simulation) {
    simulation.setup(folder);
    std::ostringstream text;
    text << "no errors found; shape quality of the worst cell: " << std::setprecision(2)
         << simulation.mesh_shape() << (simulation.mesh_shape() < 0.2 ? ", poor" : "")
         << " (1 is a box); the mesh "
         << (simulation.has_drawn_mesh() ? "is in " : "cannot be written to ") << folder
         << "/mesh.vtu";
    for (const std::string& line : simulation.modelled())
      text << "\n  " << line;
    return text.str();
  });
}

std::string default_parameters()
{
  // Materials and observables have sections once they are named; those of a free name have a Kind.
  std::string regions, materials;
  const auto add = [&](const std::string& entry, const Choice& law) {
    const std::string name = regions.empty() ? "elastomer" : "elastomer (" + law.name + ")";
    regions += (regions.empty() ? "" : ", ") + law.name + ": " + name;
    materials += "subsection " + name + "\n set " + entry + " = " + law.name + "\nend\n";
  };
  for (const Choice& law : elastic_laws())
    add("Elastic law", law);
  const std::vector<Choice> dielectrics = dielectric_laws();
  for (std::size_t i = 1; i < dielectrics.size(); ++i) // the first has been the default above
    add("Dielectric law", dielectrics[i]);
  regions += ", with branches: viscoelastic";
  materials += "subsection viscoelastic\n set Branches = " + branch_laws().front().name + "\nend\n";
  const ParameterFile example = ParameterFile::from_text(
      "subsection Regions\n set Materials = " + regions + "\nend\nsubsection Materials\n" +
      materials +
      "end\nsubsection Output\n set Observables = " + comma_separated(observables<3>().names()) +
      ", another_probe\nend\nsubsection Observables\n subsection another_probe\n  set Kind = "
      "probe\n end\nend\n");
  return Simulation<3>(MPI_COMM_SELF, example, "", silence()).parameters();
}

} // namespace thelma
