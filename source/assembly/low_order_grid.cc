#include <thelma/assembly/low_order_grid.h>
#include <thelma/assembly/stored_row.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <cmath>

namespace thelma
{

template <int dim>
LowOrderGrid<dim>::LowOrderGrid(const FieldLayout<dim>& layout,
                                const BoundaryConditions<dim>& conditions,
                                const unsigned int n_blocks, const unsigned int spacing)
    : layout(layout)
{
  find_parts(spacing);
  blocks.resize(n_blocks);
  for (unsigned int b = 0; b < blocks.size(); ++b) {
    blocks[b].first_component = b * dim;
    blocks[b].n_components = b == 0 ? dim : 1;
    const BlockVector vector = layout.new_vector();
    number_all(blocks[b], *vector.block(b).get_partitioner(), conditions);
    if (spacing > 1)
      number_some(blocks[b], vector.block(b));
    make_pattern(blocks[b]);
  }
}

/// The parts of a cell between its nodes, and linear functions on one.
template <int dim>
void LowOrderGrid<dim>::find_parts(const unsigned int spacing)
{
  const unsigned int p = layout.degree(), n = p / spacing;
  const std::vector<unsigned int> numbering =
      layout.scalar_element().get_poly_space_numbering_inverse();
  for (unsigned int part = 0; part < dealii::Utilities::fixed_power<dim>(n); ++part) {
    Corners corners;
    for (unsigned int v = 0; v < n_corners; ++v) {
      unsigned int rest = part, stride = 1, node = 0;
      for (int d = 0; d < dim; ++d) {
        node += (rest % n + (v >> d & 1)) * spacing * stride;
        rest /= n;
        stride *= p + 1;
      }
      corners[v] = numbering[node];
    }
    parts.push_back(corners);
  }
  const dealii::FE_Q<dim> linear(1);
  const dealii::QGauss<dim> rule(2);
  for (unsigned int q = 0; q < n_corners; ++q)
    for (unsigned int v = 0; v < n_corners; ++v)
      reference_gradients[q][v] = linear.shape_grad(v, rule.point(q));
}

/// As the tangent does.
template <int dim>
void LowOrderGrid<dim>::number_all(Block& block, const Partitioner& places,
                                   const BoundaryConditions<dim>& conditions)
{
  const dealii::types::global_dof_index start =
      block.first_component == 0 ? 0 : layout.owned()[0].size();
  for (unsigned int i = 0; i < places.locally_owned_size() + places.n_ghost_indices(); ++i) {
    block.numbers.push_back(static_cast<long long>(places.local_to_global(i)));
    block.free.push_back(
        !conditions.constraints().is_constrained(start + places.local_to_global(i)));
  }
  block.owned = block.relevant = places.locally_owned_range();
  block.relevant.add_indices(places.ghost_indices());
}

/// Rank by rank, in the order of the vector.
template <int dim>
void LowOrderGrid<dim>::number_some(Block& block, Vector numbers)
{
  numbers = -1.;
  for (const Cell<dim>& cell : layout.cells())
    if (block.first_component == 0 || cell.has_potential)
      for (const Corners& part : parts)
        for (const unsigned int i : unknowns(block, cell, part))
          numbers.local_element(i) = 0.;
  numbers.zero_out_ghost_values();
  const dealii::types::global_dof_index n_own = std::count(numbers.begin(), numbers.end(), 0.);
  block.owned = dealii::Utilities::MPI::create_ascending_partitioning(
      layout.communicator(),
      n_own)[dealii::Utilities::MPI::this_mpi_process(layout.communicator())];
  auto next = block.owned.begin();
  for (double& number : numbers)
    if (number == 0.)
      number = *next++;
  numbers.update_ghost_values();

  std::vector<dealii::types::global_dof_index> of_others;
  for (std::size_t i = 0; i < block.numbers.size(); ++i) {
    block.numbers[i] = static_cast<long long>(numbers.local_element(i));
    if (block.numbers[i] >= 0 && i >= numbers.locally_owned_size())
      of_others.push_back(block.numbers[i]);
  }
  std::sort(of_others.begin(), of_others.end());
  block.relevant = block.owned;
  block.relevant.add_indices(of_others.begin(), of_others.end());
}

/// Those of a part of a cell, by their place in the vector.
template <int dim>
std::vector<unsigned int> LowOrderGrid<dim>::unknowns(const Block& block, const Cell<dim>& cell,
                                                      const Corners& part) const
{
  std::vector<unsigned int> result;
  for (const unsigned int node : part)
    for (unsigned int c = 0; c < block.n_components; ++c)
      result.push_back(cell.local[node * cell.n_components + block.first_component + c]);
  return result;
}

template <int dim>
void LowOrderGrid<dim>::make_pattern(Block& block)
{
  dealii::DynamicSparsityPattern pattern(block.owned.size(), block.owned.size(), block.relevant);
  std::vector<dealii::types::global_dof_index> free;
  for (const Cell<dim>& cell : layout.cells())
    if (block.first_component == 0 || cell.has_potential)
      for (const Corners& part : parts) {
        free.clear();
        for (const unsigned int i : unknowns(block, cell, part))
          if (block.free[i])
            free.push_back(block.numbers[i]);
        std::sort(free.begin(), free.end());
        for (const auto row : free)
          pattern.add_entries(row, free.begin(), free.end(), true);
      }
  for (const auto row : block.owned)
    pattern.add(row, row);
  dealii::SparsityTools::distribute_sparsity_pattern(pattern, block.owned, layout.communicator(),
                                                     block.relevant);
  block.matrix.reinit(block.owned, block.owned, pattern, layout.communicator());
  for (const long long number : block.numbers)
    block.columns.push_back(
        number < 0 ? -1 : block.matrix.trilinos_matrix().LCID(static_cast<int>(number)));
}

template <int dim>
std::array<typename LowOrderGrid<dim>::Point, LowOrderGrid<dim>::n_corners>
LowOrderGrid<dim>::points(const Corners& part, const Positions& x) const
{
  const double weight = 1. / n_corners; // of a point of the unit cell
  std::array<Point, n_corners> result;
  for (unsigned int q = 0; q < n_corners; ++q) {
    dealii::Tensor<2, dim> jacobian;
    for (unsigned int v = 0; v < n_corners; ++v)
      jacobian += dealii::outer_product(x[part[v]], reference_gradients[q][v]);
    const double det = dealii::determinant(jacobian);
    const dealii::Tensor<2, dim> inverse = dealii::transpose(dealii::invert(jacobian));
    for (unsigned int v = 0; v < n_corners; ++v)
      result[q].gradients[v] = inverse * reference_gradients[q][v];
    result[q].weight = std::abs(det) * weight;
  }
  return result;
}

template <int dim>
void LowOrderGrid<dim>::clear()
{
  for (Block& block : blocks)
    block.matrix = 0.;
}

template <int dim>
void LowOrderGrid<dim>::add(const Cell<dim>& cell, const Positions& x, const double mu,
                            const double eps)
{
  constexpr std::size_t n = n_corners * dim;
  for (const Corners& part : parts) {
    std::array<double, n * n> shear{};
    std::array<double, n_corners * n_corners> electric{};
    for (const Point& point : points(part, x))
      for (std::size_t a = 0; a < n_corners; ++a)
        for (std::size_t b = 0; b < n_corners; ++b) {
          const auto &g = point.gradients[a], &h = point.gradients[b];
          const double product = point.weight * (g * h);
          electric[a * n_corners + b] += eps * product;
          for (int c = 0; c < dim; ++c) {
            shear[(a * dim + c) * n + b * dim + c] += mu * product;
            for (int d = 0; d < dim; ++d)
              shear[(a * dim + c) * n + b * dim + d] += mu * point.weight * g[d] * h[c];
          }
        }
    add(blocks[0], unknowns(blocks[0], cell, part), shear.data());
    if (blocks.size() > 1 && cell.has_potential)
      add(blocks[1], unknowns(blocks[1], cell, part), electric.data());
  }
}

template <int dim>
void LowOrderGrid<dim>::add(Block& block, const std::vector<unsigned int>& unknowns,
                            const double* entries)
{
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    if (block.free[unknowns[i]])
      add_row(block, unknowns, i, entries + i * unknowns.size());
}

/// Own rows are written in place, those of other ranks go the ordinary way through Trilinos.
template <int dim>
void LowOrderGrid<dim>::add_row(Block& block, const std::vector<unsigned int>& unknowns,
                                const std::size_t i, const double* entries)
{
  const long long row = block.numbers[unknowns[i]];
  if (!block.owned.is_element(row)) {
    std::vector<dealii::types::global_dof_index> columns;
    std::vector<double> values;
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      if (block.free[unknowns[j]]) {
        columns.push_back(block.numbers[unknowns[j]]);
        values.push_back(entries[j]);
      }
    block.matrix.add(row, columns.size(), columns.data(), values.data(), false);
    return;
  }
  const StoredRow stored(block.matrix.trilinos_matrix(), static_cast<int>(row));
  const double* end = stored.values + stored.n;
  double* next = stored.values;
  for (std::size_t j = 0; j < unknowns.size(); ++j)
    if (block.free[unknowns[j]]) {
      const int column = block.columns[unknowns[j]];
      if (next == end || stored.columns[next - stored.values] != column)
        next = stored.entry(column); // most often it is the component after the last one
      *next++ += entries[j];
    }
}

template <int dim>
void LowOrderGrid<dim>::finish()
{
  for (Block& block : blocks)
    fix_diagonal(block);
}

/// Rows without equation get a diagonal like that of the others.
template <int dim>
void LowOrderGrid<dim>::fix_diagonal(Block& block)
{
  SparseMatrix& matrix = block.matrix;
  matrix.compress(dealii::VectorOperation::add);
  std::vector<double> own{0., 0.}, sum(2);
  for (const auto row : block.owned)
    if (const double value = matrix.diag_element(row); value > 0.) {
      own[0] += value;
      own[1] += 1.;
    }
  dealii::Utilities::MPI::sum(own, layout.communicator(), sum);
  // Where one cell fills the gap between electrodes, all corners have given potentials.
  const double diagonal = sum[1] > 0. ? sum[0] / sum[1] : 1.;
  for (const auto row : block.owned)
    if (!(matrix.diag_element(row) > 0.))
      matrix.set(row, row, diagonal);
  matrix.compress(dealii::VectorOperation::insert);
}

template class LowOrderGrid<2>;
template class LowOrderGrid<3>;

} // namespace thelma
