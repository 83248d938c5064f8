#pragma once

#include <thelma/application/command_line.h>
#include <thelma/output/outcome.h>

#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// One combination of swept values.
struct Case {
  std::vector<Override> changes;
  std::vector<Override> overrides; ///< these and those of all cases
  std::string name;                ///< such as `Temperature.Value=273`, also of its folder
  std::string folder;              ///< in that of the study
  ParameterFile file;
  std::optional<Outcome> outcome; ///< once it is known
};

/// All combinations of the sweeps, the last one running fastest; without a sweep there is one.
/// Throws InputError if two cases have the same name.
std::vector<Case> cases_of(const CommandLine& line);

/// study.csv: a row for each case that has an outcome. The columns after the outcome are the final
/// values of all of them.
std::string study_table(const std::vector<Case>& cases);

} // namespace thelma
