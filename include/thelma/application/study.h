#pragma once

#include <thelma/application/cases.h>
#include <thelma/output/folder_lock.h>

#include <optional>

namespace thelma
{

/// The runs of a sweep, side by side on groups of ranks.
///
/// The run.json in a case's folder says that the case has ended, and how; study.csv is made of
/// these alone, so that a study that was interrupted can be continued. A case belongs to the group
/// that creates its log.txt.
class Study
{
public:
  /// Throws InputError if the cases cannot be run at all.
  Study(MPI_Comm world, const CommandLine& line);
  ~Study();
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  /// Run what has not ended yet. A case that fails is a row that says why. Returns the worst exit
  /// code; an InputError that only this group knows of, such as a full disk, ends the program.
  ExitCode run();

private:
  void find_unfinished();
  bool claim(const Case& one) const;
  void run_case(const Case& one) const;
  void publish(const Case& newest);
  void collect_outcomes();
  ExitCode conclude();

  MPI_Comm world, group;
  std::string folder;
  std::optional<FolderLock> lock; ///< of rank 0
  std::vector<Case> cases;
  std::vector<const Case*> unfinished;
};

} // namespace thelma
