#pragma once

namespace thelma
{

/// Give back to the system what many small pieces, as those of a sparsity pattern, have left in the
/// heap: large arrays, which come next, do not fit into the gaps.
void release_memory();

/// What this machine has, in bytes.
double machine_memory();

} // namespace thelma
