#pragma once

#include <thelma/base/parameters.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace thelma
{

/// The time in s at the end of every step of the run in @p folder.
std::vector<double> step_times(MPI_Comm comm, const std::string& folder);

/// Entries by which every step to @p times is taken in @p parts.
std::vector<Override> steps_in_parts(const std::vector<double>& times, unsigned int parts);

} // namespace thelma
