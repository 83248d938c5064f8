#pragma once

#include <thelma/base/parameters.h>
#include <thelma/output/outcome.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// From the start; or from the checkpoint in the folder, if there is one. One of another scene,
/// mesh or program is bad input or, for `resumed_if_same`, none.
enum class Begin { anew, resumed, resumed_if_same };

/// Run one scene on the ranks of @p comm: results into @p folder, progress to the @p console of
/// rank 0. The dimension is chosen by the file. @p arguments start the same run.
Outcome run_scene(MPI_Comm comm, const ParameterFile& file, const std::string& folder,
                  std::ostream& console, Begin begin, const std::vector<std::string>& arguments);

/// A run that is no part of a study.
struct SingleRun {
  std::string file;
  std::vector<Override> overrides;
  std::string folder;
  std::vector<std::string> arguments; ///< that start it
  bool restarts = false;

  /// A run that restarts has the scene with which it began.
  ParameterFile scene() const;

  /// How it ended, if it restarts but has ended already.
  std::optional<Outcome> earlier_end() const;

  /// One that restarts but is finished is not run again.
  Outcome run(MPI_Comm comm, std::ostream& console) const;
};

/// Whether @p folder already holds what run_scene() would write.
bool is_finished(const ParameterFile& file, const std::string& folder);

/// Read and set up the scene without running it and write its mesh into @p folder; throws
/// InputError with all problems, else a sentence about the mesh and what would be modelled.
std::string check_scene(MPI_Comm comm, const ParameterFile& file, const std::string& folder);

/// Every entry of a three-dimensional scene with all observables and a material of each elastic
/// law, with default, unit and meaning.
std::string default_parameters();

} // namespace thelma
