#pragma once

#include <thelma/solvers/block_matrix.h>
#include <thelma/solvers/linear_solver.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace thelma
{

/// The tangent with its pressures as last block (theory.md, eq. 80). Rows are scaled so that the
/// norm of a residual makes sense in whatever units its fields have.
class MixedOperator
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
  using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

  /// Copies the blocks of @p tangent, and refers to the rest.
  explicit MixedOperator(const Tangent& tangent);

  /// Blocks without the pressures.
  unsigned int size() const { return tangent.matrix.n_block_rows(); }
  const CellPressures* pressures() const { return tangent.pressures; }

  /// A zero vector of the unknowns, without ghosts.
  BlockVector new_vector() const;

  void vmult(BlockVector& y, const BlockVector& x) const;

  /// y += factor K_bc x.
  void add(unsigned int b, unsigned int c, double factor, const Vector& x, Vector& y) const;

  void scale(BlockVector& y) const;
  void unscale(BlockVector& y) const;

private:
  using Matrix = BlockMatrix<double>;

  /// Whether the blocks are an energy's second derivatives.
  bool is_symmetric(const unsigned int b, const unsigned int c) const
  {
    return std::max(b, c) < tangent.n_symmetric;
  }
  void copy(unsigned int b, unsigned int c);

  Tangent tangent;
  /// Row by row; null where nothing is, and below the diagonal of what is symmetric.
  std::vector<std::unique_ptr<Matrix>> blocks;
  std::vector<double> row_scales;
  Vector pressure_scales;
};

} // namespace thelma
