#include <thelma/solvers/mumps.h>

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>

#include <numeric>

namespace thelma
{
namespace
{

constexpr int initialise = -1, finalise = -2, analyse = 1, factorise_job = 2, solve_job = 3;

/// Call @p visit(row, column, value) for every stored entry of this rank, numbered from 0 over all
/// blocks.
template <typename Visitor>
void for_each_entry(const dealii::TrilinosWrappers::BlockSparseMatrix& matrix, const Visitor& visit)
{
  const auto& row_start = matrix.get_row_indices();
  const auto& column_start = matrix.get_column_indices();
  for (unsigned int i = 0; i < matrix.n_block_rows(); ++i)
    for (unsigned int j = 0; j < matrix.n_block_cols(); ++j) {
      const Epetra_CrsMatrix& block = matrix.block(i, j).trilinos_matrix();
      const int row_offset = row_start.block_start(i), column_offset = column_start.block_start(j);
      for (int r = 0; r < block.NumMyRows(); ++r) {
        int n = 0;
        int* local_columns = nullptr;
        double* entries = nullptr;
        block.ExtractMyRowView(r, n, entries, local_columns);
        const int row = row_offset + block.GRID(r);
        for (int k = 0; k < n; ++k)
          visit(row, column_offset + block.GCID(local_columns[k]), entries[k]);
      }
    }
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
                        : 0; // every rank brings its own entries
  mumps.icntl[27] = 1;       // sequential analysis
}

Mumps::~Mumps()
{
  run(finalise);
}

void Mumps::run(const int job)
{
  mumps.job = job;
  dmumps_c(&mumps);
}

void Mumps::collect_pattern(const dealii::TrilinosWrappers::BlockSparseMatrix& matrix)
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
  mumps.nnz_loc = mumps.nnz = rows.size();
  mumps.irn_loc = mumps.irn = rows.data();
  mumps.jcn_loc = mumps.jcn = columns.data();
  mumps.a_loc = mumps.a = values.data();
}

LinearReport Mumps::factorise(const dealii::TrilinosWrappers::BlockSparseMatrix& matrix)
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
  return outcome();
}

LinearReport Mumps::outcome() const
{
  const int code = mumps.infog[0];
  if (code >= 0) {
    // Assembly and factorisation against residual and back substitution, fitted to systems of 400
    // to 23 000 unknowns: 2 for small ones, 10 at 8 million entries of the factor.
    const double entries = mumps.infog[28] > 0 ? mumps.infog[28] : -1e6 * mumps.infog[28];
    return {true, "", true, mumps.infog[11], 2. + mumps.rinfog[0] / (72. * entries)};
  }
  return {false, code == -10 ? "the tangent is singular"
                             : "MUMPS failed with INFOG(1) = " + std::to_string(code) +
                                   ", INFOG(2) = " + std::to_string(mumps.infog[1])};
}

void Mumps::collect_layout(const dealii::LinearAlgebra::distributed::BlockVector<double>& vector)
{
  for (const auto index : vector.locally_owned_elements())
    own_indices.push_back(index);
  layout_known = true; // also on a rank that owns nothing
  const auto all = dealii::Utilities::MPI::gather(comm, own_indices);
  for (const auto& indices : all) {
    offsets.push_back(gathered_indices.size());
    counts.push_back(indices.size());
    gathered_indices.insert(gathered_indices.end(), indices.begin(), indices.end());
  }
}

void Mumps::solve(dealii::LinearAlgebra::distributed::BlockVector<double>& vector)
{
  if (!layout_known)
    collect_layout(vector);
  std::vector<double> own(own_indices.size()), gathered(gathered_indices.size());
  for (std::size_t k = 0; k < own.size(); ++k)
    own[k] = vector(own_indices[k]);

  // The right-hand side and the solution travel through rank 0.
  MPI_Gatherv(own.data(), own.size(), MPI_DOUBLE, gathered.data(), counts.data(), offsets.data(),
              MPI_DOUBLE, 0, comm);
  std::vector<double> dense(gathered.size());
  for (std::size_t k = 0; k < gathered.size(); ++k)
    dense[gathered_indices[k]] = gathered[k];
  mumps.rhs = dense.data();
  mumps.nrhs = 1;
  mumps.lrhs = mumps.n;
  run(solve_job);
  for (std::size_t k = 0; k < gathered.size(); ++k)
    gathered[k] = dense[gathered_indices[k]];
  MPI_Scatterv(gathered.data(), counts.data(), offsets.data(), MPI_DOUBLE, own.data(), own.size(),
               MPI_DOUBLE, 0, comm);

  for (std::size_t k = 0; k < own.size(); ++k)
    vector(own_indices[k]) = own[k];
}

} // namespace thelma
