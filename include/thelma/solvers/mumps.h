#pragma once

#include <thelma/solvers/linear_solver.h>

#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/trilinos_block_sparse_matrix.h>

#include <dmumps_c.h>

#include <vector>

namespace thelma
{

/// Sparse direct solver. MUMPS is called through its own C interface because Amesos always
/// factorises unsymmetrically, at twice the time and memory and without the inertia. What does not
/// fit into memory is thrown as OutOfMemory.
class Mumps
{
public:
  /// In which order unknowns are eliminated: the best there is, or one that is found at once.
  enum class Ordering { small_factor, quick };

  /// @p symmetric: LDL^T of a symmetric indefinite matrix, otherwise LU.
  Mumps(MPI_Comm comm, bool symmetric, Ordering ordering = Ordering::small_factor);
  ~Mumps();
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  /// Factorise a SparseMatrix or a BlockSparseMatrix; the pattern and the place of the entries are
  /// those of the first call.
  template <typename Matrix>
  LinearReport factorise(const Matrix& matrix);

  /// Replace the owned entries of a Vector or BlockVector by the solution with them as right-hand
  /// side.
  template <typename Vector>
  LinearReport solve(Vector& vector);

private:
  template <typename Matrix>
  void collect_pattern(const Matrix& matrix);
  void collect_layout(const dealii::IndexSet& owned);
  void run(int job);
  LinearReport outcome() const;

  MPI_Comm comm;
  DMUMPS_STRUC_C mumps;
  std::vector<int> rows, columns;
  std::vector<double> values;
  std::vector<const double*> sources;                 ///< of the values in the matrix
  std::vector<int> own_indices;                       ///< of this rank's vector entries
  std::vector<int> gathered_indices, counts, offsets; ///< of all ranks', on rank 0
  bool analysed = false, layout_known = false;
};

} // namespace thelma
