#include <thelma/solvers/single_matrix.h>

#include <deal.II/lac/full_matrix.h>

#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <algorithm>
#include <array>

namespace thelma
{
namespace
{

/// Those of a map that numbers rank by rank.
dealii::IndexSet own_indices(const Epetra_Map& map)
{
  dealii::IndexSet result(map.NumGlobalElements());
  if (map.NumMyElements() > 0)
    result.add_range(map.MinMyGID(), map.MaxMyGID() + 1);
  return result;
}

/// The groups of @p needed of which others hold one.
dealii::IndexSet groups_of_others(const Epetra_Map& needed, const Epetra_Map& own,
                                  const unsigned int group)
{
  std::vector<dealii::types::global_dof_index> indices;
  for (int i = 0; i < needed.NumMyElements(); ++i)
    if (const int index = needed.GID(i); !own.MyGID(index))
      for (unsigned int c = 0; c < group; ++c)
        indices.push_back(index - index % group + c);
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  dealii::IndexSet result(own.NumGlobalElements());
  result.add_indices(indices.begin(), indices.end());
  return result;
}

/// A stored row by Trilinos' local numbers.
struct Row {
  Row(const Epetra_CrsMatrix& matrix, const unsigned int row)
  {
    matrix.ExtractMyRowView(static_cast<int>(row), size, values, columns);
  }
  int size = 0;
  double* values = nullptr;
  int* columns = nullptr;
};

struct Product {
  const std::vector<std::size_t>& starts;
  const std::vector<unsigned int>& places;
  const float *values, *x;
  float factor, keep;
  float* y;

  /// For blocks of @p n x @p m entries.
  template <unsigned int n, unsigned int m>
  void run() const
  {
    for (std::size_t row = 0; row + 1 < starts.size(); ++row) {
      std::array<float, n * m> sums{}; // one for each entry, so that none waits for another
      for (std::size_t k = starts[row]; k < starts[row + 1]; ++k)
        for (unsigned int j = 0; j < m; ++j)
          for (unsigned int i = 0; i < n; ++i)
            sums[j * n + i] += values[k * n * m + j * n + i] * x[places[k] + j];
      for (unsigned int i = 0; i < n; ++i) {
        float sum = 0.F;
        for (unsigned int j = 0; j < m; ++j)
          sum += sums[j * n + i];
        float& result = y[row * n + i];
        result = factor * sum + (keep == 0.F ? 0.F : keep * result);
      }
    }
  }

  template <unsigned int n>
  void run(const unsigned int m) const
  {
    m == 1 ? run<n, 1>() : m == 2 ? run<n, 2>() : run<n, 3>();
  }
};

} // namespace

SingleMatrix::SingleMatrix(const Epetra_CrsMatrix& matrix, const unsigned int group_of_rows,
                           const unsigned int group_of_columns)
    : n(group_of_rows), m(group_of_columns),
      communicator(dynamic_cast<const Epetra_MpiComm&>(matrix.Comm()).Comm()),
      rows(own_indices(matrix.RowMap())),
      columns(std::make_shared<Partitioner>(
          own_indices(matrix.DomainMap()),
          groups_of_others(matrix.ColMap(), matrix.DomainMap(), m), communicator))
{
  copy(matrix);
  needed.reinit(columns);
}

void SingleMatrix::copy(const Epetra_CrsMatrix& matrix)
{
  std::vector<unsigned int> local; // place of Trilinos' local columns
  for (int j = 0; j < matrix.ColMap().NumMyElements(); ++j)
    local.push_back(columns->global_to_local(matrix.ColMap().GID(j)));
  // Where a block stands, plus one; whatever stands before the row's begin is of another row.
  std::vector<std::size_t> found((columns->locally_owned_size() + columns->n_ghost_indices()) / m);
  starts.assign(1, 0);
  values.reserve(matrix.NumMyNonzeros());
  places.reserve(matrix.NumMyNonzeros() / (n * m));
  for (unsigned int first = 0; first < rows.n_elements(); first += n) {
    for (unsigned int i = 0; i < n; ++i) {
      const Row row(matrix, first + i);
      for (int k = 0; k < row.size; ++k) {
        const unsigned int place = local[row.columns[k]];
        std::size_t& block = found[place / m];
        if (block <= starts.back()) {
          places.push_back(place - place % m);
          values.resize(values.size() + n * m);
          block = places.size();
        }
        values[((block - 1) * m + place % m) * n + i] = static_cast<float>(row.values[k]);
      }
    }
    starts.push_back(places.size());
  }
}

SingleMatrix SingleMatrix::inverse_of_diagonal() const
{
  SingleMatrix result;
  result.n = result.m = n;
  result.communicator = communicator;
  result.rows = rows;
  result.columns = std::make_shared<Partitioner>(rows, communicator);
  result.needed.reinit(result.columns);
  result.starts.assign(1, 0);
  dealii::FullMatrix<double> block(n, n);
  for (std::size_t row = 0; row + 1 < starts.size(); ++row) {
    for (std::size_t k = starts[row]; k < starts[row + 1]; ++k)
      if (places[k] == row * n)
        for (unsigned int entry = 0; entry < n * n; ++entry)
          block(entry % n, entry / n) = values[k * n * n + entry];
    block.gauss_jordan();
    result.places.push_back(row * n);
    result.starts.push_back(result.places.size());
    for (unsigned int entry = 0; entry < n * n; ++entry)
      result.values.push_back(static_cast<float>(block(entry % n, entry / n)));
  }
  return result;
}

void SingleMatrix::multiply(const float factor, const Vector& x, const float keep, Vector& y) const
{
  const Product product{starts, places, values.data(), with_ghosts(x), factor, keep, y.begin()};
  n == 1 ? product.run<1>(m) : n == 2 ? product.run<2>(m) : product.run<3>(m);
}

SingleMatrix::Vector SingleMatrix::vector_of_columns() const
{
  return Vector(columns->locally_owned_range(), communicator);
}

const float* SingleMatrix::with_ghosts(const Vector& x) const
{
  if (columns->n_mpi_processes() == 1)
    return x.begin();
  needed.zero_out_ghost_values();
  needed.copy_locally_owned_data_from(x);
  needed.update_ghost_values();
  return needed.begin();
}

} // namespace thelma
