#include <thelma/solvers/block_matrix.h>

#include <deal.II/lac/full_matrix.h>

#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

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
    if (const unsigned int index = needed.GID(i); !own.MyGID(needed.GID(i)))
      for (unsigned int c = 0; c < group; ++c)
        indices.push_back(index - index % group + c);
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  dealii::IndexSet result(own.NumGlobalElements());
  result.add_indices(indices.begin(), indices.end());
  return result;
}

/// Call @p function with the two numbers, of 1 to 3, as constants.
template <typename Function>
void with_constants(const unsigned int n, const unsigned int m, const Function& function)
{
  using One = std::integral_constant<unsigned int, 1>;
  using Two = std::integral_constant<unsigned int, 2>;
  using Three = std::integral_constant<unsigned int, 3>;
  const auto with = [&](const auto first) {
    m == 1 ? function(first, One()) : m == 2 ? function(first, Two()) : function(first, Three());
  };
  n == 1 ? with(One()) : n == 2 ? with(Two()) : with(Three());
}

/// y += factor A x; @p and_transposed also with A^T. A row of blocks has a sum for each entry of a
/// block, so that none waits for another.
template <unsigned int n, unsigned int m, bool and_transposed, typename Blocks, typename Number>
void multiply(const Blocks& blocks, const Number factor, const Number* x, Number* y)
{
  constexpr std::size_t size = std::size_t(n) * m;
  for (std::size_t row = 0; row + 1 < blocks.starts.size(); ++row) {
    std::array<Number, size> sums{};
    std::array<Number, n> own{};
    if constexpr (and_transposed)
      for (unsigned int i = 0; i < n; ++i)
        own[i] = factor * x[row * n + i];
    for (std::size_t k = blocks.starts[row]; k < blocks.starts[row + 1]; ++k) {
      const Number* entry = &blocks.values[k * size];
      for (unsigned int j = 0; j < m; ++j) {
        Number sum = 0.;
        for (unsigned int i = 0; i < n; ++i) {
          sums[j * n + i] += entry[j * n + i] * x[blocks.places[k] + j];
          sum += entry[j * n + i] * own[i];
        }
        if constexpr (and_transposed)
          y[blocks.places[k] + j] += sum;
      }
    }
    for (unsigned int i = 0; i < n; ++i) {
      Number sum = 0.;
      for (unsigned int j = 0; j < m; ++j)
        sum += sums[j * n + i];
      y[row * n + i] += factor * sum;
    }
  }
}

/// y += factor A^T x.
template <unsigned int n, unsigned int m, typename Blocks, typename Number>
void multiply_transposed(const Blocks& blocks, const Number factor, const Number* x, Number* y)
{
  constexpr std::size_t size = std::size_t(n) * m;
  for (std::size_t row = 0; row + 1 < blocks.starts.size(); ++row)
    for (std::size_t k = blocks.starts[row]; k < blocks.starts[row + 1]; ++k)
      for (std::size_t j = 0; j < m; ++j)
        for (std::size_t i = 0; i < n; ++i)
          y[blocks.places[k] + j] += factor * blocks.values[k * size + j * n + i] * x[row * n + i];
}

} // namespace

template <typename Number>
BlockMatrix<Number>::BlockMatrix(const Epetra_CrsMatrix& matrix, const unsigned int group_of_rows,
                                 const unsigned int group_of_columns)
    : BlockMatrix(matrix, group_of_rows, group_of_columns, false)
{
}

template <typename Number>
BlockMatrix<Number>::BlockMatrix(const Epetra_CrsMatrix& matrix, const unsigned int group)
    : BlockMatrix(matrix, group, group, true)
{
}

template <typename Number>
BlockMatrix<Number>::BlockMatrix(const Epetra_CrsMatrix& matrix, const unsigned int group_of_rows,
                                 const unsigned int group_of_columns, const bool symmetric)
    : n(group_of_rows), m(group_of_columns),
      communicator(dynamic_cast<const Epetra_MpiComm&>(matrix.Comm()).Comm()),
      rows(own_indices(matrix.RowMap())),
      columns(std::make_shared<Partitioner>(
          own_indices(matrix.DomainMap()), groups_of_others(matrix.ColMap(), matrix.DomainMap(), m),
          communicator)),
      needed(columns)
{
  copy(matrix, symmetric);
}

template <typename Number>
void BlockMatrix<Number>::copy(const Epetra_CrsMatrix& matrix, const bool symmetric)
{
  std::vector<unsigned int> local; // place of Trilinos' local columns in a vector
  local.reserve(matrix.ColMap().NumMyElements());
  for (int j = 0; j < matrix.ColMap().NumMyElements(); ++j)
    local.push_back(columns->global_to_local(matrix.ColMap().GID(j)));
  const std::size_t n_own = columns->locally_owned_size();
  // The last row that had a block in this column, and where.
  struct Found {
    unsigned int row = std::numeric_limits<unsigned int>::max();
    std::size_t block = 0;
  };
  std::vector<Found> found((n_own + columns->n_ghost_indices()) / m);
  Blocks& most = symmetric ? twice : once;
  const std::size_t n_most = matrix.NumMyNonzeros() / (symmetric ? 2 : 1);
  most.values.reserve(n_most + n_most / 16);
  most.places.reserve((n_most + n_most / 16) / (std::size_t(n) * m));
  for (unsigned int row = 0; row * n < rows.n_elements(); ++row) {
    for (unsigned int i = 0; i < n; ++i) {
      int size = 0, *indices = nullptr;
      double* entries = nullptr;
      matrix.ExtractMyRowView(static_cast<int>(row * n + i), size, entries, indices);
      for (int k = 0; k < size; ++k) {
        const unsigned int place = local[indices[k]], column = place / m;
        const bool is_own = place < n_own;
        if (symmetric && is_own && column < row)
          continue;
        Blocks& blocks = symmetric && is_own && column > row ? twice : once;
        if (found[column].row != row) {
          found[column] = {row, blocks.places.size()};
          blocks.places.push_back(column * m);
          blocks.values.resize(blocks.values.size() + std::size_t(n) * m);
        }
        blocks.values[(found[column].block * m + place % m) * n + i] =
            static_cast<Number>(entries[k]);
      }
    }
    once.starts.push_back(once.places.size());
    if (symmetric)
      twice.starts.push_back(twice.places.size());
  }
}

template <typename Number>
BlockMatrix<Number> BlockMatrix<Number>::inverse_of_diagonal() const
{
  BlockMatrix result;
  result.n = result.m = n;
  result.communicator = communicator;
  result.rows = rows;
  result.columns = std::make_shared<Partitioner>(rows, communicator);
  result.needed.reinit(result.columns);
  dealii::FullMatrix<double> block(n, n);
  for (std::size_t row = 0; row + 1 < once.starts.size(); ++row) {
    block = 0.;
    for (std::size_t k = once.starts[row]; k < once.starts[row + 1]; ++k)
      if (once.places[k] == row * n)
        for (unsigned int entry = 0; entry < n * n; ++entry)
          block(entry % n, entry / n) = once.values[k * n * n + entry];
    for (unsigned int i = 0; i < n; ++i)
      if (block(i, i) == 0.) // nothing depends on it
        block(i, i) = 1.;
    block.gauss_jordan();
    for (unsigned int entry = 0; entry < n * n; ++entry)
      result.once.values.push_back(static_cast<Number>(block(entry % n, entry / n)));
    result.once.places.push_back(row * n);
    result.once.starts.push_back(row + 1);
  }
  return result;
}

template <typename Number>
void BlockMatrix<Number>::add(const Number factor, const Vector& x, Vector& y) const
{
  const Number* source = with_ghosts(x);
  with_constants(n, m, [&](const auto n, const auto m) {
    multiply<n(), m(), false>(once, factor, source, y.begin());
    if constexpr (n() == m())
      multiply<n(), m(), true>(twice, factor, source, y.begin());
  });
}

template <typename Number>
void BlockMatrix<Number>::add_transposed(const Number factor, const Vector& x, Vector& y) const
{
  Assert(twice.places.empty(), dealii::ExcMessage("a symmetric matrix is its own transpose"));
  needed = 0.;
  with_constants(n, m, [&](const auto n, const auto m) {
    multiply_transposed<n(), m()>(once, factor, x.begin(), needed.begin());
  });
  needed.compress(dealii::VectorOperation::add);
  y += needed;
}

template <typename Number>
const Number* BlockMatrix<Number>::with_ghosts(const Vector& x) const
{
  if (columns->n_mpi_processes() == 1)
    return x.begin();
  needed.zero_out_ghost_values();
  needed.copy_locally_owned_data_from(x);
  needed.update_ghost_values();
  return needed.begin();
}

template class BlockMatrix<double>;
template class BlockMatrix<float>;

} // namespace thelma
