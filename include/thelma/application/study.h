#pragma once

#include <thelma/application/command_line.h>
#include <thelma/output/outcome.h>

namespace thelma
{

/// Run every combination of the sweeps and write study.csv into the output folder, a row per
/// case. A case that fails is a row that says why. Returns the worst exit code.
ExitCode run_study(const CommandLine& line);

} // namespace thelma
