#include <thelma/assembly/tangent_matrix.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <array>

namespace thelma
{
namespace
{

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
void TangentMatrix<dim>::clear()
{
  // Nothing of other ranks is left over, finish() has sent it away; Trilinos would go row by row.
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
  std::array<double*, n_field_kinds> begins;
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
