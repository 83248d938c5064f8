#include <thelma/base/error.h>
#include <thelma/solvers/mumps.h>

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>

namespace thelma
{
namespace
{

constexpr int initialise = -1, finalise = -2, analyse = 1, factorise_job = 2, solve_job = 3;

/// Call @p visit(row, column, value) for every stored entry of this rank.
template <typename Visitor>
void for_each_entry(const dealii::TrilinosWrappers::SparseMatrix& matrix, const Visitor& visit)
{
  const Epetra_CrsMatrix& stored = matrix.trilinos_matrix();
  for (int r = 0; r < stored.NumMyRows(); ++r) {
    int n = 0;
    int* local_columns = nullptr;
    double* entries = nullptr;
    stored.ExtractMyRowView(r, n, entries, local_columns);
    for (int k = 0; k < n; ++k)
      visit(stored.GRID(r), stored.GCID(local_columns[k]), entries[k]);
  }
}

/// The same, numbered from 0 over all blocks.
template <typename Visitor>
void for_each_entry(const dealii::TrilinosWrappers::BlockSparseMatrix& matrix, const Visitor& visit)
{
  for (unsigned int i = 0; i < matrix.n_block_rows(); ++i)
    for (unsigned int j = 0; j < matrix.n_block_cols(); ++j) {
      const int row = static_cast<int>(matrix.get_row_indices().block_start(i)),
                column = static_cast<int>(matrix.get_column_indices().block_start(j));
      for_each_entry(matrix.block(i, j), [&](const int r, const int c, const double& value) {
        visit(row + r, column + c, value);
      });
    }
}

/// Codes of arrays that could not be allocated, and of a workspace that is still too small when it
/// cannot grow.
bool lacks_memory(const int code)
{
  constexpr std::array<int, 9> codes{{-5, -7, -8, -9, -11, -13, -14, -15, -19}};
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

} // namespace

Mumps::Mumps(const MPI_Comm comm, const bool symmetric, const Ordering ordering)
    : comm(comm), mumps()
{
  mumps.comm_fortran = MPI_Comm_c2f(comm);
  mumps.par = 1;
  mumps.sym = symmetric ? 2 : 0;
  run(initialise);
  mumps.icntl[0] = mumps.icntl[1] = mumps.icntl[2] = -1; // no messages
  mumps.icntl[3] = 0;
  mumps.icntl[6] = ordering == Ordering::small_factor ? 4 : 2; // PORD, AMF
  if (symmetric)
    mumps.icntl[7] = 0; // no scaling: the units of the fields already balance the tangent
  mumps.icntl[12] = 1;  // no ScaLAPACK root, whose pivots are not counted
  mumps.icntl[13] = 50; // per cent of extra workspace for pivoting
  mumps.icntl[17] = dealii::Utilities::MPI::n_mpi_processes(comm) > 1
                        ? 3
                        : 0;    // every rank brings its own entries
  mumps.icntl[27] = 1;          // sequential analysis
  mumps.icntl[32] = !symmetric; // the determinant
}

Mumps::~Mumps()
{
  // An exception may have hit this rank alone, and the others would never come here.
  if (std::uncaught_exceptions() == 0)
    run(finalise);
}

void Mumps::run(const int job)
{
  mumps.job = job;
  dmumps_c(&mumps);
}

template <typename Matrix>
void Mumps::collect_pattern(const Matrix& matrix)
{
  rows.clear();
  columns.clear();
  sources.clear();
  for_each_entry(matrix, [&](const int i, const int j, const double& value) {
    if (mumps.sym == 0 || i <= j) {
      rows.push_back(i + 1);
      columns.push_back(j + 1);
      sources.push_back(&value);
    }
  });
  values.resize(rows.size());
  mumps.n = matrix.m();
  mumps.nnz_loc = mumps.nnz = static_cast<std::int64_t>(rows.size());
  mumps.irn_loc = mumps.irn = rows.data();
  mumps.jcn_loc = mumps.jcn = columns.data();
  mumps.a_loc = mumps.a = values.data();
}

template <typename Matrix>
LinearReport Mumps::factorise(const Matrix& matrix)
{
  if (!analysed)
    collect_pattern(matrix);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = *sources[k];
  if (!analysed) {
    run(analyse);
    if (mumps.infog[0] < 0)
      return outcome();
    analysed = true;
  }
  run(factorise_job);
  while ((mumps.infog[0] == -8 || mumps.infog[0] == -9) && mumps.icntl[13] < 1000) {
    mumps.icntl[13] *= 2; // more delayed pivots than foreseen
    run(factorise_job);
  }
  LinearReport report = outcome();
  if (mumps.sym == 0 && report.solved) // rank 0 alone has the sign of the permutation
    report.negative_pivots = dealii::Utilities::MPI::broadcast(comm, report.negative_pivots, 0);
  return report;
}

LinearReport Mumps::outcome() const
{
  const int code = mumps.infog[0];
  if (code >= 0) {
    // Assembly and factorisation against residual and back substitution, fitted to systems of 400
    // to 23 000 unknowns: 2 for small ones, 10 at 8 million entries of the factor.
    const double entries = mumps.infog[28] > 0 ? mumps.infog[28] : -1e6 * mumps.infog[28];
    const long long negative = mumps.sym != 0 ? mumps.infog[11] : mumps.rinfog[11] < 0.;
    return {true, "", true, negative, 2. + mumps.rinfog[0] / (72. * entries)};
  }
  if (lacks_memory(code))
    throw OutOfMemory(
        "out of memory: MUMPS finds no room for the factors of " + std::to_string(mumps.n) +
        " unknowns (INFOG(1) = " + std::to_string(code) +
        "); choose a coarser mesh in the section Mesh, the block solver, or a machine "
        "with more");
  return {false, code == -10 ? "the tangent is singular"
                             : "MUMPS failed with INFOG(1) = " + std::to_string(code) +
                                   ", INFOG(2) = " + std::to_string(mumps.infog[1])};
}

void Mumps::collect_layout(const dealii::IndexSet& owned)
{
  for (const auto index : owned)
    own_indices.push_back(static_cast<int>(index));
  layout_known = true; // also on a rank that owns nothing
  const auto all = dealii::Utilities::MPI::gather(comm, own_indices);
  for (const auto& indices : all) {
    offsets.push_back(static_cast<int>(gathered_indices.size()));
    counts.push_back(static_cast<int>(indices.size()));
    gathered_indices.insert(gathered_indices.end(), indices.begin(), indices.end());
  }
}

template <typename Vector>
LinearReport Mumps::solve(Vector& vector)
{
  if (!layout_known)
    collect_layout(vector.locally_owned_elements());
  std::vector<double> own(own_indices.size()), gathered(gathered_indices.size());
  for (std::size_t k = 0; k < own.size(); ++k)
    own[k] = vector(own_indices[k]);

  // The right-hand side and the solution travel through rank 0.
  MPI_Gatherv(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, gathered.data(), counts.data(),
              offsets.data(), MPI_DOUBLE, 0, comm);
  std::vector<double> dense(gathered.size());
  for (std::size_t k = 0; k < gathered.size(); ++k)
    dense[gathered_indices[k]] = gathered[k];
  mumps.rhs = dense.data();
  mumps.nrhs = 1;
  mumps.lrhs = mumps.n;
  run(solve_job);
  for (std::size_t k = 0; k < gathered.size(); ++k)
    gathered[k] = dense[gathered_indices[k]];
  MPI_Scatterv(gathered.data(), counts.data(), offsets.data(), MPI_DOUBLE, own.data(),
               static_cast<int>(own.size()), MPI_DOUBLE, 0, comm);

  for (std::size_t k = 0; k < own.size(); ++k)
    vector(own_indices[k]) = own[k];
  const LinearReport report = outcome();
  return {report.solved, report.reason};
}

template LinearReport Mumps::factorise(const dealii::TrilinosWrappers::SparseMatrix&);
template LinearReport Mumps::factorise(const dealii::TrilinosWrappers::BlockSparseMatrix&);
template LinearReport Mumps::solve(dealii::LinearAlgebra::distributed::Vector<double>&);
template LinearReport Mumps::solve(dealii::LinearAlgebra::distributed::BlockVector<double>&);

} // namespace thelma
