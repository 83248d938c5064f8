#pragma once

#include <thelma/solvers/block_matrix.h>
#include <thelma/solvers/linear_solver.h>
#include <thelma/solvers/mumps.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <vector>

namespace thelma
{

/// One cycle of multigrid as an approximate inverse: from the matrix itself to a given coarse grid,
/// if there is one, and from there on to aggregates, which ML makes. The cycle runs in single
/// precision, since the bytes it reads are what it costs.
class Multigrid
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<float>;
  using Matrix = dealii::TrilinosWrappers::SparseMatrix;

  /// @p n_components unknowns of a node follow one another; @p null_space holds what the coarse
  /// grid's matrix, or else the only one, hardly sees, constants if it is empty. @p degree is that
  /// of the polynomial that smooths a matrix which has a coarse grid.
  LinearReport setup(const Matrix& matrix, const CoarseGrid& coarse, unsigned int n_components,
                     const std::vector<std::vector<double>>& null_space, unsigned int degree = 1);

  void vmult(Vector& x, const Vector& b) const { cycle(0, x, b); }
  void vmult(dealii::LinearAlgebra::distributed::Vector<double>& x,
             const dealii::LinearAlgebra::distributed::Vector<double>& b) const;

private:
  using Smoother = dealii::PreconditionChebyshev<BlockMatrix<float>, Vector, BlockMatrix<float>>;

  /// What is done to unknowns before and after coarser ones.
  struct Level {
    BlockMatrix<float> matrix, prolongation;
    Smoother smoother;
    mutable Vector residual, coarse_residual, coarse_correction;
  };

  void cycle(std::size_t level, Vector& x, const Vector& b) const;
  LinearReport add_aggregates(const Matrix& matrix, unsigned int n_components,
                              const std::vector<std::vector<double>>& null_space);
  void add_level(const Epetra_CrsMatrix& matrix, unsigned int group,
                 BlockMatrix<float>&& prolongation, unsigned int degree);

  std::vector<std::unique_ptr<Level>> levels; ///< from fine to coarse
  std::unique_ptr<Mumps> coarsest;
};

} // namespace thelma
