#pragma once

#include <thelma/base/parameters.h>
#include <thelma/output/outcome.h>

#include <iosfwd>
#include <string>

namespace thelma
{

/// Run one scene on the ranks of @p comm: results into @p folder, progress to the @p console of
/// rank 0. The dimension is chosen by the file.
Outcome run_scene(MPI_Comm comm, const ParameterFile& file, const std::string& folder,
                  std::ostream& console);

/// Whether @p folder already holds what run_scene() would write.
bool is_finished(const ParameterFile& file, const std::string& folder);

/// Read and set up the scene without running it; throws InputError with all problems, else a
/// sentence about the mesh.
std::string check_scene(MPI_Comm comm, const ParameterFile& file);

/// Every entry of a three-dimensional scene with one material, with default, unit and meaning.
std::string default_parameters();

} // namespace thelma
