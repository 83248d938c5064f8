#pragma once

#include <deal.II/base/subscriptor.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Epetra_CrsMatrix.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace thelma
{

/// A copy of a sparse matrix for fast products: dense blocks of the components of a node, of a
/// symmetric matrix only one of each pair. Products take about the time in which it is read, and
/// there is less to read than of a general matrix (doc/scaling.md).
template <typename Number>
class BlockMatrix : public dealii::Subscriptor
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<Number>;
  using size_type = typename Vector::size_type;

  BlockMatrix() = default;

  /// Rows and columns come in groups of 1 to 3, all of one on the same rank. What a block lacks in
  /// @p matrix is zero.
  BlockMatrix(const Epetra_CrsMatrix& matrix, unsigned int group_of_rows,
              unsigned int group_of_columns);

  /// A symmetric one.
  BlockMatrix(const Epetra_CrsMatrix& matrix, unsigned int group);

  /// y += factor A x or, unless it is symmetric, factor A^T x; vectors without ghosts.
  void add(Number factor, const Vector& x, Vector& y) const;
  void add_transposed(Number factor, const Vector& x, Vector& y) const;

  void vmult(Vector& y, const Vector& x) const
  {
    y = Number(0.);
    add(1., x, y);
  }

  /// The inverses of the blocks on the diagonal.
  BlockMatrix inverse_of_diagonal() const;

  /// Zero vectors.
  Vector vector_of_rows() const { return Vector(rows, communicator); }
  Vector vector_of_columns() const { return Vector(columns->locally_owned_range(), communicator); }

private:
  using Partitioner = dealii::Utilities::MPI::Partitioner;

  struct Blocks {
    std::vector<std::size_t> starts{0}; ///< of each row of blocks
    std::vector<unsigned int> places;   ///< of the blocks' first columns in a vector with ghosts
    std::vector<Number> values;         ///< of a block column by column
  };

  BlockMatrix(const Epetra_CrsMatrix& matrix, unsigned int group_of_rows,
              unsigned int group_of_columns, bool symmetric);
  void copy(const Epetra_CrsMatrix& matrix, bool symmetric);
  const Number* with_ghosts(const Vector& x) const;

  unsigned int n = 1, m = 1; ///< rows and columns of a block
  MPI_Comm communicator = MPI_COMM_SELF;
  dealii::IndexSet rows;
  std::shared_ptr<const Partitioner> columns; ///< own ones and those that the own rows need
  Blocks once;                                ///< blocks as they are
  Blocks twice;          ///< blocks above the diagonal that stand for those below it too
  mutable Vector needed; ///< of all columns, with ghosts
};

} // namespace thelma
