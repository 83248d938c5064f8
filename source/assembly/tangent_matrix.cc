#include <thelma/assembly/tangent_matrix.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/block_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace thelma
{
namespace
{

using BlockMatrix = dealii::TrilinosWrappers::BlockSparseMatrix;

/// A stored row of a block, by Trilinos' local numbers.
struct Row {
  Row(const Epetra_CrsMatrix& block, const dealii::types::global_dof_index row)
  {
    block.ExtractMyRowView(block.LRID(static_cast<int>(row)), n, values, columns);
  }

  /// Epetra sorts the columns of a matrix that is complete.
  double* entry(const int column) const
  {
    return values + (std::lower_bound(columns, columns + n, column) - columns);
  }

  int n = 0;
  double* values = nullptr;
  int* columns = nullptr;
};

/// Finds a cell's rows in the matrix; Trilinos' own numbers are looked up once a cell.
class CellColumns
{
public:
  CellColumns(const BlockMatrix& matrix, const std::vector<dealii::types::global_dof_index>& dofs,
              const std::vector<unsigned int>& block)
      : matrix(matrix), block(block), ids(matrix.n_block_rows())
  {
    for (const auto dof : dofs)
      indices.push_back(matrix.get_row_indices().global_to_local(dof).second);
    for (unsigned int b = 0; b < ids.size(); ++b)
      for (std::size_t j = 0; j < dofs.size(); ++j)
        ids[b].push_back(matrix.block(b, block[j]).trilinos_matrix().LCID(indices[j]));
  }

  /// Find row @p i, an own one, with the @p coupled unknowns; @p starts are those of its blocks'
  /// values.
  void find(const std::size_t i, const std::vector<unsigned int>& coupled, double* const* starts,
            CellRows& cell) const
  {
    std::vector<Row> rows;
    for (unsigned int b = 0; b < ids.size(); ++b) {
      rows.emplace_back(matrix.block(block[i], b).trilinos_matrix(), indices[i]);
      cell.begins[i * ids.size() + b] = static_cast<int>(rows[b].values - starts[b]);
    }
    for (const unsigned int j : coupled) {
      const Row& row = rows[block[j]];
      cell.offsets[i * block.size() + j] =
          static_cast<int>(row.entry(ids[block[i]][j]) - row.values);
    }
  }

private:
  const BlockMatrix& matrix;
  const std::vector<unsigned int>& block;
  std::vector<int> indices;          ///< of the cell's unknowns in their blocks
  std::vector<std::vector<int>> ids; ///< [block of the row][unknown of the cell]
};

/// Add the @p entries of a run, most often as many as a node has displacements.
void add_run(const unsigned int length, const double* entries, double* values)
{
  switch (length) {
  case 3:
    values[2] += entries[2];
    [[fallthrough]];
  case 2:
    values[1] += entries[1];
    [[fallthrough]];
  case 1:
    values[0] += entries[0];
    break;
  default:
    for (unsigned int k = 0; k < length; ++k)
      values[k] += entries[k];
  }
}

} // namespace

template <int dim>
void TangentMatrix<dim>::setup(const FieldLayout<dim>& layout,
                               const BoundaryConditions<dim>& conditions, Coupling pairs)
{
  constraints = &conditions.constraints();
  coupling = std::move(pairs);
  make_pattern(layout);
  find_places(layout);
}

/// The unknowns of @p cell that have an entry in the row of its unknown @p i.
template <int dim>
std::vector<unsigned int> TangentMatrix<dim>::columns(const Cell<dim>& cell, const std::size_t i,
                                                      const std::vector<bool>& is_free) const
{
  std::vector<unsigned int> result;
  if (!is_free[i])
    return result;
  for (unsigned int d = 0; d < cell.n_components; ++d)
    if (coupling(cell, i % cell.n_components, d))
      for (unsigned int j = d; j < cell.dofs.size(); j += cell.n_components)
        if (is_free[j])
          result.push_back(j);
  return result;
}

template <int dim>
std::vector<bool> TangentMatrix<dim>::free_unknowns(const Cell<dim>& cell) const
{
  std::vector<bool> result;
  for (const auto dof : cell.dofs)
    result.push_back(!constraints->is_constrained(dof));
  return result;
}

template <int dim>
void TangentMatrix<dim>::make_pattern(const FieldLayout<dim>& layout)
{
  dealii::BlockDynamicSparsityPattern pattern(layout.relevant());
  std::vector<dealii::types::global_dof_index> row;
  for (const Cell<dim>& cell : layout.cells()) {
    const std::vector<bool> is_free = free_unknowns(cell);
    for (std::size_t i = 0; i < cell.dofs.size(); ++i) {
      row.assign(1, cell.dofs[i]);
      for (const unsigned int j : columns(cell, i, is_free))
        row.push_back(cell.dofs[j]);
      std::sort(row.begin(), row.end());
      row.erase(std::unique(row.begin(), row.end()), row.end());
      pattern.add_entries(cell.dofs[i], row.begin(), row.end(), true);
    }
  }
  for (const auto& line : constraints->get_lines())
    pattern.add(line.index, line.index);
  dealii::IndexSet relevant(layout.dof_handler().n_dofs());
  dealii::types::global_dof_index begin = 0;
  for (const dealii::IndexSet& block : layout.relevant()) {
    relevant.add_indices(block, begin);
    begin += block.size();
  }
  dealii::SparsityTools::distribute_sparsity_pattern(
      pattern, layout.dof_handler().locally_owned_dofs(), layout.communicator(), relevant);
  tangent.reinit(layout.owned(), pattern, layout.communicator());
  tangent.compress(dealii::VectorOperation::add);
}

template <int dim>
double* TangentMatrix<dim>::entry(const dealii::types::global_dof_index row,
                                  const dealii::types::global_dof_index column)
{
  const auto& start = tangent.get_row_indices();
  const auto [i, r] = start.global_to_local(row);
  const auto [j, c] = start.global_to_local(column);
  const Epetra_CrsMatrix& block = tangent.block(i, j).trilinos_matrix();
  return Row(block, r).entry(block.LCID(static_cast<int>(c)));
}

template <int dim>
void TangentMatrix<dim>::find_places(const FieldLayout<dim>& layout)
{
  const dealii::IndexSet owned = layout.dof_handler().locally_owned_dofs();
  const unsigned int n_blocks = tangent.n_block_rows();
  block_values.clear();
  for (unsigned int i = 0; i < n_blocks; ++i)
    for (unsigned int j = 0; j < n_blocks; ++j) {
      int *row_starts = nullptr, *columns = nullptr;
      block_values.push_back(nullptr);
      const int error = tangent.block(i, j).trilinos_matrix().ExtractCrsDataPointers(
          row_starts, columns, block_values.back());
      AssertThrow(error == 0, dealii::ExcMessage("the matrix is not stored contiguously"));
    }

  std::set<double*> diagonals;
  for (const auto& line : constraints->get_lines())
    if (owned.is_element(line.index))
      diagonals.insert(entry(line.index, line.index));
  places.clear();
  for (const Cell<dim>& cell : layout.cells()) {
    const std::size_t n = cell.dofs.size();
    std::vector<unsigned int> block(n);
    for (std::size_t i = 0; i < n; ++i)
      block[i] = layout.block_of_dof(cell.dofs[i]);
    CellRows rows(block, n_blocks);
    const std::vector<bool> is_free = free_unknowns(cell);
    const CellColumns local(tangent, cell.dofs, block);
    for (std::size_t i = 0; i < n; ++i) {
      rows.own[i] = owned.is_element(cell.dofs[i]);
      const std::vector<unsigned int> coupled = columns(cell, i, is_free);
      if (rows.own[i])
        local.find(i, coupled, block_values.data() + block[i] * n_blocks, rows);
      else
        for (const unsigned int j : coupled)
          rows.offsets[i * n + j] = 0;
      if (rows.own[i] && rows.offsets[i * n + i] == CellRows::absent)
        diagonals.insert(entry(cell.dofs[i], cell.dofs[i]));
    }
    places.emplace_back(rows);
  }
  fixed_diagonals.assign(diagonals.begin(), diagonals.end());
}

template <int dim>
void TangentMatrix<dim>::clear()
{
  // Nothing of other ranks is left over: finish() has sent it away. Zeros that go straight to
  // memory take half the time of Trilinos' own.
  const unsigned int n_blocks = tangent.n_block_rows();
  for (unsigned int k = 0; k < block_values.size(); ++k) {
    const auto& block = tangent.block(k / n_blocks, k % n_blocks).trilinos_matrix();
    std::fill_n(block_values[k], block.NumMyNonzeros(), 0.);
  }
  for (double* diagonal : fixed_diagonals)
    *diagonal = 1.;
}

template <int dim>
void TangentMatrix<dim>::add(const std::size_t index, const Cell<dim>& cell,
                             const std::vector<double>& entries)
{
  const std::size_t n = cell.dofs.size();
  const CellPlaces& place = places[index];
  for (std::size_t i = 0; i < n; ++i) {
    // The rows lie far apart: memory is asked for the next one in time.
    if (i + 1 < n)
      for_each_run(place, i + 1,
                   [](const CellPlaces::Run&, double* values) { __builtin_prefetch(values, 1); });
    const double* row = entries.data() + i * n;
    if (place.rows[i].own)
      for_each_run(place, i, [row](const CellPlaces::Run& run, double* values) {
        add_run(run.length, row + run.first, values);
      });
    else if (place.rows[i].pattern != CellPlaces::no_pattern)
      add_row(cell, i, place, row);
  }
}

/// Call @p visit(run, its values in the matrix) for those of the own row @p i of a cell, if it is
/// one and has any.
template <int dim>
template <typename Visitor>
void TangentMatrix<dim>::for_each_run(const CellPlaces& place, const std::size_t i,
                                      const Visitor& visit) const
{
  const CellPlaces::Row& row = place.rows[i];
  if (!row.own || row.pattern == CellPlaces::no_pattern)
    return;
  const std::size_t n_blocks = tangent.n_block_rows();
  std::array<double*, 3> begins;
  for (std::size_t b = 0; b < n_blocks; ++b)
    begins[b] = block_values[row.block * n_blocks + b] + place.begins[i * n_blocks + b];
  const unsigned short* offset = place.offsets_of(row);
  for (const CellPlaces::Run& run : place.runs) {
    if (*offset != CellPlaces::absent)
      visit(run, begins[run.block] + *offset);
    ++offset;
  }
}

template <int dim>
void TangentMatrix<dim>::add_row(const Cell<dim>& cell, const std::size_t i,
                                 const CellPlaces& place, const double* entries)
{
  std::vector<dealii::types::global_dof_index> indices;
  std::vector<double> values;
  const unsigned short* offset = place.offsets_of(place.rows[i]);
  for (const CellPlaces::Run& run : place.runs)
    if (*offset++ != CellPlaces::absent)
      for (unsigned int j = run.first; j < run.first + run.length; ++j) {
        indices.push_back(cell.dofs[j]);
        values.push_back(entries[j]);
      }
  tangent.add(cell.dofs[i], indices.size(), indices.data(), values.data(), false);
}

template <int dim>
void TangentMatrix<dim>::add_diagonal(const dealii::types::global_dof_index unknown,
                                      const double value)
{
  if (!constraints->is_constrained(unknown))
    *entry(unknown, unknown) += value;
}

template <int dim>
void TangentMatrix<dim>::finish()
{
  tangent.compress(dealii::VectorOperation::add);
}

template class TangentMatrix<2>;
template class TangentMatrix<3>;

} // namespace thelma
