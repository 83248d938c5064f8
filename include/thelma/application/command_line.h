#pragma once

#include <thelma/base/parameters.h>

#include <string>
#include <vector>

namespace thelma
{

/// An entry and the values it takes in a parameter study.
struct Sweep {
  Override entry;
  std::vector<std::string> values;
};

/// What the user asked for.
struct CommandLine {
  enum class Action { run, check, material_point, list, defaults, version, help };

  /// `@FILE` stands for the arguments in that file, `--restart DIR` for those with which the run in
  /// DIR was started, in the folder where it was. Throws InputError for what it does not
  /// understand.
  static CommandLine parse(const std::vector<std::string>& arguments);

  static std::string help();

  Action action = Action::run;
  std::string topic; ///< the word after help, list or defaults: show that part
  std::string file;
  std::string output; ///< default: output/<name of the file>
  std::vector<Override> overrides;
  std::vector<Sweep> sweeps;
  unsigned int ranks_per_case = 1;
  bool estimates = false; ///< of the mesh's error
  bool restarts = false;
  std::vector<std::string> arguments; ///< all of them, none that stands for others
};

} // namespace thelma
