#pragma once

#include <thelma/solvers/multigrid.h>
#include <thelma/solvers/mumps.h>

#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/trilinos_block_sparse_matrix.h>

#include <memory>

namespace thelma
{

/// Solves again and again with a positive matrix in whose first block components follow one another
/// and in whose others nothing stands: by factors or, in bodies whose factors are too large, by
/// conjugate gradients with multigrid to 1e-6.
class Laplacian
{
public:
  using Matrix = dealii::TrilinosWrappers::BlockSparseMatrix;
  using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

  /// @p matrix must live on if the solver @p iterates.
  Laplacian(const Matrix& matrix, unsigned int n_components, bool iterates);

  /// Replace the owned entries of the first block by the solution with them as right-hand side.
  void solve(BlockVector& vector);

private:
  const Matrix* matrix = nullptr; ///< if it iterates
  Multigrid multigrid;
  std::unique_ptr<Mumps> factors; ///< or else
};

} // namespace thelma
