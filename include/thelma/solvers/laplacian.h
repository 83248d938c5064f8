#pragma once

#include <thelma/solvers/block_matrix.h>
#include <thelma/solvers/multigrid.h>
#include <thelma/solvers/mumps.h>

#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/trilinos_block_sparse_matrix.h>

#include <memory>

namespace thelma
{

/// Solves again and again with a positive matrix whose first block couples no components and in
/// whose others nothing stands: by factors or, in bodies whose factors are too large, by conjugate
/// gradients with multigrid to 1e-6.
class Laplacian
{
public:
  using Matrix = dealii::TrilinosWrappers::BlockSparseMatrix;
  using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

  Laplacian(const Matrix& matrix, bool iterates);

  /// Replace the owned entries of the first block by the solution with them as right-hand side, or
  /// by zero where there is no room for factors: it serves a guess.
  void solve(BlockVector& vector);

private:
  bool works = true;
  BlockMatrix<double> block; ///< if it iterates
  Multigrid multigrid;
  std::unique_ptr<Mumps> factors; ///< or else
};

} // namespace thelma
