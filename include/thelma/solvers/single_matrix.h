#pragma once

#include <deal.II/lac/la_parallel_vector.h>

#include <Epetra_CrsMatrix.h>

#include <memory>
#include <vector>

namespace thelma
{

/// A sparse matrix in single precision, stored in dense blocks of up to 3 x 3 entries: a product
/// reads a third of the bytes that one with a general matrix of doubles does, and costs nothing
/// else. Good enough for whatever is corrected by a residual of full precision.
class SingleMatrix
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<float>;
  using size_type = Vector::size_type;

  SingleMatrix() = default;

  /// Copy @p matrix, whose rows and columns come in groups of so many; all of a group are on one
  /// rank. Whatever a block lacks there is zero here.
  SingleMatrix(const Epetra_CrsMatrix& matrix, unsigned int group_of_rows,
               unsigned int group_of_columns);

  /// The inverses of the blocks on the diagonal, of a square matrix.
  SingleMatrix inverse_of_diagonal() const;

  /// y = factor A x + keep y; the vectors are such as the next two functions give.
  void multiply(float factor, const Vector& x, float keep, Vector& y) const;
  void vmult(Vector& y, const Vector& x) const { multiply(1.F, x, 0.F, y); }

  /// Zero vectors without ghosts.
  Vector vector_of_rows() const { return Vector(rows, communicator); }
  Vector vector_of_columns() const;

private:
  using Partitioner = dealii::Utilities::MPI::Partitioner;

  void copy(const Epetra_CrsMatrix& matrix);
  const float* with_ghosts(const Vector& x) const;

  unsigned int n = 0, m = 0; ///< entries of a block: n rows, m columns
  MPI_Comm communicator = MPI_COMM_SELF;
  dealii::IndexSet rows;
  std::shared_ptr<const Partitioner> columns; ///< own ones and those that this rank's rows need
  std::vector<std::size_t> starts;            ///< of the rows of blocks
  std::vector<unsigned int> places;           ///< of the blocks' first columns in a vector
  std::vector<float> values;                  ///< of a block column by column
  mutable Vector needed;                      ///< what a product takes, with ghosts
};

} // namespace thelma
