#include <thelma/assembly/low_order.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <cmath>

namespace thelma
{

template <int dim>
LowOrder<dim>::LowOrder(const FieldLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
                        const State& state)
    : layout(layout), conditions(conditions), state(state), nodes(layout.new_vector())
{
  dealii::types::global_dof_index start = 0;
  for (const dealii::IndexSet& block : layout.owned()) {
    starts.push_back(start);
    start += block.size();
  }
  find_parts();
  find_nodes();
  matrices.resize(layout.has(Field::potential) ? 2 : 1);
  for (unsigned int block = 0; block < matrices.size(); ++block)
    make_pattern(block);
}

/// The parts of a cell between its nodes, and linear functions on one.
template <int dim>
void LowOrder<dim>::find_parts()
{
  const unsigned int p = layout.degree();
  const std::vector<unsigned int> numbering =
      layout.scalar_element().get_poly_space_numbering_inverse();
  for (unsigned int part = 0; part < dealii::Utilities::fixed_power<dim>(p); ++part) {
    Corners corners;
    for (unsigned int v = 0; v < n_corners; ++v) {
      unsigned int rest = part, stride = 1, node = 0;
      for (int d = 0; d < dim; ++d) {
        node += (rest % p + (v >> d & 1)) * stride;
        rest /= p;
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

template <int dim>
void LowOrder<dim>::find_nodes()
{
  const auto& support = layout.scalar_element().get_unit_support_points();
  for (const Cell<dim>& cell : layout.cells())
    for (std::size_t a = 0; a < support.size(); ++a) {
      const auto X = layout.mapping().transform_unit_to_real_cell(cell.iterator, support[a]);
      for (int c = 0; c < dim; ++c)
        nodes.block(0).local_element(cell.local[a * cell.n_components + c]) = X[c];
    }
}

/// Rows of a part's unknowns in a block, -1 where there is no equation.
template <int dim>
std::vector<long long> LowOrder<dim>::rows(const unsigned int block, const Cell<dim>& cell,
                                           const Corners& part) const
{
  std::vector<long long> result;
  const unsigned int first = block == 0 ? 0 : dim, n = components(block);
  for (const unsigned int node : part)
    for (unsigned int c = first; c < first + n; ++c) {
      const auto dof = cell.dofs[node * cell.n_components + c];
      const bool given = conditions.constraints().is_constrained(dof);
      result.push_back(given ? -1 : static_cast<long long>(dof - starts[block]));
    }
  return result;
}

template <int dim>
void LowOrder<dim>::make_pattern(const unsigned int block)
{
  const dealii::IndexSet &owned = layout.owned()[block], &relevant = layout.relevant()[block];
  dealii::DynamicSparsityPattern pattern(owned.size(), owned.size(), relevant);
  std::vector<dealii::types::global_dof_index> free;
  for (const Cell<dim>& cell : layout.cells())
    if (block == 0 || cell.has_potential)
      for (const Corners& part : parts) {
        free.clear();
        for (const long long row : rows(block, cell, part))
          if (row >= 0)
            free.push_back(row);
        std::sort(free.begin(), free.end());
        for (const auto row : free)
          pattern.add_entries(row, free.begin(), free.end(), true);
      }
  for (const auto row : owned)
    pattern.add(row, row);
  dealii::SparsityTools::distribute_sparsity_pattern(pattern, owned, layout.communicator(),
                                                     relevant);
  matrices[block].reinit(owned, owned, pattern, layout.communicator());
}

template <int dim>
std::array<typename LowOrder<dim>::Point, LowOrder<dim>::n_corners>
LowOrder<dim>::points(const Positions& x) const
{
  const double weight = 1. / n_corners; // of a point of the unit cell
  std::array<Point, n_corners> result;
  for (unsigned int q = 0; q < n_corners; ++q) {
    dealii::Tensor<2, dim> jacobian;
    for (unsigned int v = 0; v < n_corners; ++v)
      jacobian += dealii::outer_product(x[v], reference_gradients[q][v]);
    const double det = dealii::determinant(jacobian);
    const dealii::Tensor<2, dim> inverse = dealii::transpose(dealii::invert(jacobian));
    for (unsigned int v = 0; v < n_corners; ++v)
      result[q].gradients[v] = inverse * reference_gradients[q][v];
    result[q].weight = std::abs(det) * weight;
  }
  return result;
}

template <int dim>
void LowOrder<dim>::update()
{
  for (SparseMatrix& matrix : matrices)
    matrix = 0.;
  nodes.update_ghost_values();
  std::vector<double> X, u;
  for (const Cell<dim>& cell : layout.cells()) {
    layout.gather(cell, nodes, X);
    layout.gather(cell, state.x, u);
    const double theta = layout.has(Field::temperature) ? u[cell.n_components - 1] : state.theta;
    const double mu = cell.material->shear_modulus(theta), eps = cell.material->permittivity(theta);
    for (const Corners& part : parts) {
      Positions x;
      for (unsigned int v = 0; v < n_corners; ++v)
        for (int c = 0; c < dim; ++c)
          x[v][c] = X[part[v] * cell.n_components + c] + u[part[v] * cell.n_components + c];
      assemble(cell, x, part, mu, eps);
    }
  }
  nodes.zero_out_ghost_values();
  for (unsigned int block = 0; block < matrices.size(); ++block)
    fix_diagonal(block);
  find_motions();
}

template <int dim>
void LowOrder<dim>::assemble(const Cell<dim>& cell, const Positions& x, const Corners& part,
                             const double mu, const double eps)
{
  constexpr unsigned int n = n_corners * dim;
  std::vector<double> shear(n * n, 0.), electric(n_corners * n_corners, 0.);
  for (const Point& point : points(x))
    for (unsigned int a = 0; a < n_corners; ++a)
      for (unsigned int b = 0; b < n_corners; ++b) {
        const auto &g = point.gradients[a], &h = point.gradients[b];
        const double product = point.weight * (g * h);
        electric[a * n_corners + b] += eps * product;
        for (int c = 0; c < dim; ++c) {
          shear[(a * dim + c) * n + b * dim + c] += mu * product;
          for (int d = 0; d < dim; ++d)
            shear[(a * dim + c) * n + b * dim + d] += mu * point.weight * g[d] * h[c];
        }
      }
  add(0, cell, part, shear);
  if (cell.has_potential)
    add(1, cell, part, electric);
}

template <int dim>
void LowOrder<dim>::add(const unsigned int block, const Cell<dim>& cell, const Corners& part,
                        const std::vector<double>& entries)
{
  const std::vector<long long> all = rows(block, cell, part);
  std::vector<dealii::types::global_dof_index> columns;
  std::vector<double> values;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] < 0)
      continue;
    columns.clear();
    values.clear();
    for (std::size_t j = 0; j < all.size(); ++j)
      if (all[j] >= 0) {
        columns.push_back(all[j]);
        values.push_back(entries[i * all.size() + j]);
      }
    matrices[block].add(all[i], columns.size(), columns.data(), values.data(), false);
  }
}

/// Rows without equation get a diagonal like that of the others.
template <int dim>
void LowOrder<dim>::fix_diagonal(const unsigned int block)
{
  SparseMatrix& matrix = matrices[block];
  matrix.compress(dealii::VectorOperation::add);
  std::vector<double> own{0., 0.}, sum(2);
  for (const auto row : layout.owned()[block])
    if (const double value = matrix.diag_element(row); value > 0.) {
      own[0] += value;
      own[1] += 1.;
    }
  dealii::Utilities::MPI::sum(own, layout.communicator(), sum);
  for (const auto row : layout.owned()[block])
    if (!(matrix.diag_element(row) > 0.))
      matrix.set(row, row, sum[0] / sum[1]);
  matrix.compress(dealii::VectorOperation::insert);
}

template <int dim>
const dealii::TrilinosWrappers::SparseMatrix* LowOrder<dim>::matrix(const unsigned int block) const
{
  return block < matrices.size() ? &matrices[block] : nullptr;
}

/// Translations and rotations of the deformed body, about its middle.
template <int dim>
void LowOrder<dim>::find_motions()
{
  const auto& partitioner = *nodes.block(0).get_partitioner();
  const std::size_t n_own = partitioner.locally_owned_size();
  const auto position = [&](const std::size_t i) {
    return nodes.block(0).local_element(i) + state.x.block(0).local_element(i);
  };
  std::vector<double> own(dim, 0.), centre(dim);
  for (std::size_t i = 0; i < n_own; ++i)
    own[i % dim] += position(i);
  dealii::Utilities::MPI::sum(own, layout.communicator(), centre);
  for (double& value : centre)
    value *= static_cast<double>(dim) / static_cast<double>(partitioner.size());

  motions.assign(dim * (dim + 1) / 2, std::vector<double>(n_own, 0.));
  for (std::size_t i = 0; i < n_own; ++i) {
    const unsigned int c = i % dim;
    if (conditions.constraints().is_constrained(partitioner.local_to_global(i)))
      continue;
    motions[c][i] = 1.;
    unsigned int motion = dim;
    for (unsigned int j = 0; j < dim; ++j)
      for (unsigned int k = j + 1; k < dim; ++k, ++motion) // turn the axis j towards k
        if (c == j || c == k) {
          const unsigned int other = j + k - c;
          motions[motion][i] = (c == k ? 1. : -1.) * (position(i - c + other) - centre[other]);
        }
  }
}

template class LowOrder<2>;
template class LowOrder<3>;

} // namespace thelma
