#pragma once

#include <thelma/base/parameters.h>

#include <string>
#include <vector>

namespace thelma
{

/// How a run or a study was started: the file command.txt in its folder.
struct RunCommand {
  std::string directory; ///< from where
  std::vector<std::string> arguments;

  /// The @p arguments given here.
  static RunCommand here(const std::vector<std::string>& arguments);

  /// Throws InputError if nothing was started into @p folder.
  static RunCommand read(const std::string& folder);

  /// Throws WriteError if there is no room in the folder.
  void write(const std::string& folder) const;
};

/// Those that run the scene in @p file with @p overrides.
std::vector<std::string> arguments_for(const std::string& file,
                                       const std::vector<Override>& overrides);

} // namespace thelma
