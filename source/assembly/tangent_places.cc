// Where the entries of the tangent stand.

#include <thelma/assembly/stored_row.h>
#include <thelma/assembly/tangent_matrix.h>

#include <deal.II/lac/block_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <set>
#include <utility>

namespace thelma
{
namespace
{

using SparseMatrices = dealii::TrilinosWrappers::BlockSparseMatrix;

/// Finds a cell's rows in the matrix; Trilinos' own numbers are looked up once a cell.
class CellColumns
{
public:
  CellColumns(const SparseMatrices& matrix,
              const std::vector<dealii::types::global_dof_index>& dofs,
              const std::vector<unsigned int>& block)
      : matrix(matrix), block(block), ids(matrix.n_block_rows())
  {
    for (const auto dof : dofs)
      indices.push_back(static_cast<int>(matrix.get_row_indices().global_to_local(dof).second));
    for (unsigned int b = 0; b < ids.size(); ++b)
      for (std::size_t j = 0; j < dofs.size(); ++j)
        ids[b].push_back(matrix.block(b, block[j]).trilinos_matrix().LCID(indices[j]));
  }

  /// Find row @p i, an own one, with the @p coupled unknowns; @p starts are those of its blocks'
  /// values.
  void find(const std::size_t i, const std::vector<unsigned int>& coupled, double* const* starts,
            CellRows& cell) const
  {
    std::vector<StoredRow> rows;
    for (unsigned int b = 0; b < ids.size(); ++b) {
      rows.emplace_back(matrix.block(block[i], b).trilinos_matrix(), indices[i]);
      cell.begins[i * ids.size() + b] = static_cast<int>(rows[b].values - starts[b]);
    }
    for (const unsigned int j : coupled) {
      const StoredRow& row = rows[block[j]];
      cell.offsets[i * block.size() + j] =
          static_cast<int>(row.entry(ids[block[i]][j]) - row.values);
    }
  }

private:
  const SparseMatrices& matrix;
  const std::vector<unsigned int>& block;
  std::vector<int> indices;          ///< of the cell's unknowns in their blocks
  std::vector<std::vector<int>> ids; ///< [block of the row][unknown of the cell]
};

} // namespace

template <int dim>
void TangentMatrix<dim>::setup(const DofLayout<dim>& layout,
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
void TangentMatrix<dim>::make_pattern(const DofLayout<dim>& layout)
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
  return StoredRow(block, static_cast<int>(r)).entry(block.LCID(static_cast<int>(c)));
}

template <int dim>
void TangentMatrix<dim>::find_places(const DofLayout<dim>& layout)
{
  const dealii::IndexSet owned = layout.dof_handler().locally_owned_dofs();
  const std::size_t n_blocks = tangent.n_block_rows();
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

template void TangentMatrix<2>::setup(const DofLayout<2>&, const BoundaryConditions<2>&, Coupling);
template void TangentMatrix<3>::setup(const DofLayout<3>&, const BoundaryConditions<3>&, Coupling);
template double* TangentMatrix<2>::entry(dealii::types::global_dof_index,
                                         dealii::types::global_dof_index);
template double* TangentMatrix<3>::entry(dealii::types::global_dof_index,
                                         dealii::types::global_dof_index);

} // namespace thelma
