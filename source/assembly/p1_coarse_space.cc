#include <thelma/assembly/corner_grid.h>
#include <thelma/assembly/stored_row.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>

namespace thelma
{

template <int dim>
P1CoarseSpace<dim>::P1CoarseSpace(const DofLayout<dim>& layout,
                                  const BoundaryConditions<dim>& conditions,
                                  const unsigned int block)
    : layout(layout), block(block), components(block == 0 ? dim : 1)
{
  const BlockVector vectors = layout.new_vector();
  const Vector& vector = vectors.block(block);
  const auto& places = *vector.get_partitioner();
  const dealii::types::global_dof_index start = block == 0 ? 0 : layout.owned()[0].size();
  for (unsigned int i = 0; i < places.locally_owned_size() + places.n_ghost_indices(); ++i)
    free.push_back(!conditions.constraints().is_constrained(start + places.local_to_global(i)));
  number_corners(vector);
  make_matrix();
  make_prolongation(vector);
}

template <int dim>
std::vector<unsigned int> P1CoarseSpace<dim>::unknowns(const Cell<dim>& cell) const
{
  std::vector<unsigned int> result;
  for (std::size_t v = 0; v < n_corners; ++v)
    for (unsigned int c = 0; c < components; ++c)
      result.push_back(unknown(cell, v, c));
  return result;
}

/// Rank by rank, in the order of the vector.
template <int dim>
void P1CoarseSpace<dim>::number_corners(Vector new_numbers)
{
  new_numbers = -1.;
  for (const Cell<dim>& cell : layout.cells())
    if (has_field(cell))
      for (const unsigned int i : unknowns(cell))
        new_numbers.local_element(i) = 0.;
  new_numbers.zero_out_ghost_values();
  const dealii::types::global_dof_index n_own =
      std::count(new_numbers.begin(), new_numbers.end(), 0.);
  owned = dealii::Utilities::MPI::create_ascending_partitioning(
      layout.communicator(),
      n_own)[dealii::Utilities::MPI::this_mpi_process(layout.communicator())];
  auto next = owned.begin();
  for (double& number : new_numbers)
    if (number == 0.)
      number = *next++;
  new_numbers.update_ghost_values();

  std::vector<dealii::types::global_dof_index> of_others;
  for (std::size_t i = 0; i < free.size(); ++i) {
    numbers.push_back(static_cast<long long>(new_numbers.local_element(i)));
    if (numbers[i] >= 0 && i >= new_numbers.locally_owned_size())
      of_others.push_back(numbers[i]);
  }
  std::sort(of_others.begin(), of_others.end());
  relevant = owned;
  relevant.add_indices(of_others.begin(), of_others.end());
}

template <int dim>
void P1CoarseSpace<dim>::make_matrix()
{
  dealii::DynamicSparsityPattern pattern(owned.size(), owned.size(), relevant);
  std::vector<dealii::types::global_dof_index> together;
  for (const Cell<dim>& cell : layout.cells())
    if (has_field(cell)) {
      together.clear();
      for (const unsigned int i : unknowns(cell))
        if (free[i])
          together.push_back(numbers[i]);
      std::sort(together.begin(), together.end());
      for (const auto row : together)
        pattern.add_entries(row, together.begin(), together.end(), true);
    }
  for (const auto row : owned)
    pattern.add(row, row);
  dealii::SparsityTools::distribute_sparsity_pattern(pattern, owned, layout.communicator(),
                                                     relevant);
  values.reinit(owned, owned, pattern, layout.communicator());
  for (const long long number : numbers)
    columns.push_back(number < 0 ? -1 : values.trilinos_matrix().LCID(static_cast<int>(number)));
}

/// Linear between the corners of a cell, and nothing of or for what has no equation.
template <int dim>
void P1CoarseSpace<dim>::make_prolongation(const Vector& vector)
{
  const dealii::FE_Q<dim> linear(1);
  const auto& nodes = layout.scalar_element().get_unit_support_points();
  const auto& places = *vector.get_partitioner();
  const auto for_each_weight = [&](const auto& visit) {
    for (const Cell<dim>& cell : layout.cells())
      if (has_field(cell))
        for (std::size_t a = 0; a < nodes.size(); ++a)
          for (unsigned int c = 0; c < components; ++c) {
            const unsigned int i = unknown(cell, a, c);
            if (!free[i] || i >= places.locally_owned_size())
              continue;
            for (std::size_t v = 0; v < n_corners; ++v) {
              const unsigned int j = unknown(cell, v, c);
              const double weight = linear.shape_value(v, nodes[a]);
              if (weight > 0. && free[j])
                visit(places.local_to_global(i), numbers[j], weight);
            }
          }
  };
  const dealii::IndexSet& rows = places.locally_owned_range();
  dealii::DynamicSparsityPattern pattern(rows.size(), owned.size(), rows);
  for_each_weight([&](const auto i, const long long j, double) { pattern.add(i, j); });
  interpolation.reinit(rows, owned, pattern, layout.communicator());
  for_each_weight([&](const auto i, const long long j, const double weight) {
    interpolation.set(i, j, weight);
  });
  interpolation.compress(dealii::VectorOperation::insert);
}

template <int dim>
void P1CoarseSpace<dim>::add(const Cell<dim>& cell, const double* entries)
{
  if (!has_field(cell))
    return;
  const std::vector<unsigned int> of_cell = unknowns(cell);
  for (std::size_t i = 0; i < of_cell.size(); ++i)
    if (free[of_cell[i]])
      add_row(of_cell, i, entries + i * of_cell.size());
}

/// Own rows are written in place, those of other ranks go the ordinary way through Trilinos.
template <int dim>
void P1CoarseSpace<dim>::add_row(const std::vector<unsigned int>& of_cell, const std::size_t i,
                                 const double* entries)
{
  const long long row = numbers[of_cell[i]];
  if (!owned.is_element(row)) {
    std::vector<dealii::types::global_dof_index> indices;
    std::vector<double> nonzeros;
    for (std::size_t j = 0; j < of_cell.size(); ++j)
      if (free[of_cell[j]]) {
        indices.push_back(numbers[of_cell[j]]);
        nonzeros.push_back(entries[j]);
      }
    values.add(row, indices.size(), indices.data(), nonzeros.data(), false);
    return;
  }
  const StoredRow stored(values.trilinos_matrix(), static_cast<int>(row));
  const double* end = stored.values + stored.n;
  double* next = stored.values;
  for (std::size_t j = 0; j < of_cell.size(); ++j)
    if (free[of_cell[j]]) {
      const int column = columns[of_cell[j]];
      if (next == end || stored.columns[next - stored.values] != column)
        next = stored.entry(column); // most often it is the component after the last one
      *next++ += entries[j];
    }
}

template <int dim>
void P1CoarseSpace<dim>::finish()
{
  values.compress(dealii::VectorOperation::add);
  std::vector<double> own{0., 0.}, sum(2);
  for (const auto row : owned)
    if (const double value = values.diag_element(row); value > 0.) {
      own[0] += value;
      own[1] += 1.;
    }
  dealii::Utilities::MPI::sum(own, layout.communicator(), sum);
  // Where one cell fills the gap between electrodes, all corners have given potentials.
  const double diagonal = sum[1] > 0. ? sum[0] / sum[1] : 1.;
  for (const auto row : owned)
    if (!(values.diag_element(row) > 0.))
      values.set(row, row, diagonal);
  values.compress(dealii::VectorOperation::insert);
}

template class P1CoarseSpace<2>;
template class P1CoarseSpace<3>;

} // namespace thelma
