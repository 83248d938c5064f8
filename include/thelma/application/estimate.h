#pragma once

#include <thelma/application/command_line.h>
#include <thelma/output/outcome.h>

#include <iosfwd>

namespace thelma
{

/// Run the scene of @p line, then with every cell halved and, where that is affordable, halved
/// again, and a transient one with every time step halved and halved again; print how far each
/// number of the report probably lies from that of an infinitely fine mesh and infinitely short
/// steps, and write it to estimate.csv (theory.md, "Error estimates"). Returns the outcome of the
/// given run.
Outcome run_with_estimate(MPI_Comm comm, const CommandLine& line, std::ostream& console);

} // namespace thelma
