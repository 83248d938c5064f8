#pragma once

#include <thelma/application/command_line.h>
#include <thelma/output/outcome.h>

#include <iosfwd>

namespace thelma
{

/// Run one scene into @p folder; the dimension is chosen by the file.
Outcome run_scene(const ParameterFile& file, const std::string& folder);

/// Read and set up the scene without running it.
void check_scene(const ParameterFile& file);

/// Every entry of a three-dimensional scene with one material, with default, unit and meaning.
void print_defaults(std::ostream& out);

/// Run every combination of the sweeps and write study.csv into the output folder, a row per
/// case. A case that fails is a row that says why. Returns the worst exit code.
ExitCode run_study(const CommandLine& line);

} // namespace thelma
