#pragma once

#include <thelma/solvers/linear_solver.h>

#include <deal.II/lac/trilinos_precondition.h>

#include <memory>
#include <vector>

namespace thelma
{

/// One algebraic multigrid cycle (ML, smoothed aggregation) as an approximate inverse.
class Multigrid
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
  using Matrix = dealii::TrilinosWrappers::SparseMatrix;

  /// @p n_components unknowns of a node follow one another; @p null_space holds what the matrix
  /// hardly sees, constants if it is empty.
  void setup(const Matrix& matrix, unsigned int n_components,
             const std::vector<std::vector<double>>& null_space);

  void vmult(Vector& x, const Vector& b) const { cycle->vmult(x, b); }

private:
  std::vector<double> modes; ///< ML reads them later
  std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> cycle;
};

} // namespace thelma
