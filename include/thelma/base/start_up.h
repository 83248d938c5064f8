#pragma once

namespace thelma
{

/// What a process sets before MPI starts: one thread for the BLAS, and without mpirun no more of
/// Open MPI than one process needs. What the environment sets already stays.
void prepare_process();

} // namespace thelma
