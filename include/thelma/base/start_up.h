#pragma once

#include <deal.II/base/mpi.h>

#include <array>

namespace thelma
{

/// MPI and the libraries that deal.II starts with it, from here to the end of this object. The BLAS
/// has one thread, and of Open MPI there is no more than the run needs; what the environment sets
/// already stays.
class Process
{
public:
  /// @p name is that of the program. PETSc, one of the libraries, does not see its other arguments:
  /// it would take some for its own and warn of the rest.
  explicit Process(char* name);

  /// To be called last, with the exit code, which it returns. A process that mpirun did not start
  /// ends with it within seconds, whatever Open MPI waits for.
  int end(int code) const;

private:
  bool alone;
  std::array<char*, 2> names;
  char** argv = names.data();
  int argc = 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi;
};

} // namespace thelma
