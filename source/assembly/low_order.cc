#include <thelma/assembly/low_order.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace thelma
{

template <int dim>
LowOrder<dim>::LowOrder(const FieldLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
                        const State& state)
    : layout(layout), state(state), nodes(layout.new_vector()), fine(layout, conditions, 1, 1)
{
  find_nodes();
  if (layout.degree() > 1) {
    const unsigned int n_blocks = layout.has(Field::potential) ? 2 : 1;
    corners = std::make_unique<LowOrderGrid<dim>>(layout, conditions, n_blocks, layout.degree());
    prolongations.resize(n_blocks);
    for (unsigned int block = 0; block < n_blocks; ++block)
      make_prolongation(block);
  }
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
  nodes.update_ghost_values();
}

/// Linear between the corners of a cell, and nothing of or for what has no equation.
template <int dim>
void LowOrder<dim>::make_prolongation(const unsigned int block)
{
  const dealii::FE_Q<dim> linear(1);
  const auto& support = layout.scalar_element().get_unit_support_points(); // the corners first
  const BlockVector vector = layout.new_vector();
  const auto& places = *vector.block(block).get_partitioner();
  const auto for_each_weight = [&](const auto& visit) {
    for (const Cell<dim>& cell : layout.cells())
      if (block == 0 || cell.has_potential)
        for (std::size_t a = 0; a < support.size(); ++a)
          for (unsigned int c = block * dim; c < block * dim + components(block); ++c) {
            const unsigned int i = cell.local[a * cell.n_components + c];
            if (corners->is_free(block, i) && i < places.locally_owned_size())
              for (unsigned int v = 0; v < linear.dofs_per_cell; ++v) {
                const unsigned int j = cell.local[v * cell.n_components + c];
                const double weight = linear.shape_value(v, support[a]);
                if (weight > 0. && corners->is_free(block, j))
                  visit(places.local_to_global(i), corners->number(block, j), weight);
              }
          }
  };
  const dealii::IndexSet &rows = places.locally_owned_range(), &columns = corners->owned(block);
  dealii::DynamicSparsityPattern pattern(rows.size(), columns.size(), rows);
  for_each_weight([&](const long long i, const long long j, double) { pattern.add(i, j); });
  prolongations[block].reinit(rows, columns, pattern, layout.communicator());
  for_each_weight([&](const long long i, const long long j, const double weight) {
    prolongations[block].set(i, j, weight);
  });
  prolongations[block].compress(dealii::VectorOperation::insert);
}

template <int dim>
void LowOrder<dim>::update()
{
  fine.clear();
  if (corners)
    corners->clear();
  std::vector<double> X, u;
  for (const Cell<dim>& cell : layout.cells()) {
    layout.gather(cell, nodes, X);
    layout.gather(cell, state.x, u);
    typename LowOrderGrid<dim>::Positions x(X.size() / cell.n_components);
    for (std::size_t a = 0; a < x.size(); ++a)
      for (int c = 0; c < dim; ++c)
        x[a][c] = X[a * cell.n_components + c] + u[a * cell.n_components + c];
    const double theta = layout.has(Field::temperature) ? u[cell.n_components - 1] : state.theta;
    const double mu = cell.material->shear_modulus(theta), eps = cell.material->permittivity(theta);
    fine.add(cell, x, mu, eps);
    if (corners)
      corners->add(cell, x, mu, eps);
  }
  fine.finish();
  if (corners)
    corners->finish();
  find_motions();
}

template <int dim>
Surrogate LowOrder<dim>::surrogate(const unsigned int block) const
{
  const Field field = layout.fields()[block];
  const bool has_coarser = block < prolongations.size();
  return {field == Field::displacement ? &fine.matrix(block) : nullptr, field == Field::potential,
          has_coarser ? &corners->matrix(block) : nullptr,
          has_coarser ? &prolongations[block] : nullptr};
}

/// Translations and rotations of the deformed body about its middle, at the nodes of the coarser
/// grid.
template <int dim>
void LowOrder<dim>::find_motions()
{
  const LowOrderGrid<dim>& grid = corners ? *corners : fine;
  const std::size_t n_all = nodes.block(0).locally_owned_size();
  const auto position = [&](const std::size_t i) {
    return nodes.block(0).local_element(i) + state.x.block(0).local_element(i);
  };
  std::vector<double> own(dim, 0.), centre(dim);
  for (std::size_t i = 0; i < n_all; ++i)
    own[i % dim] += position(i);
  dealii::Utilities::MPI::sum(own, layout.communicator(), centre);
  for (double& value : centre)
    value *= static_cast<double>(dim) / static_cast<double>(nodes.block(0).size());

  motions.assign(dim * (dim + 1) / 2, {});
  for (std::size_t i = 0; i < n_all; ++i) {
    if (grid.number(0, i) < 0)
      continue;
    for (auto& motion : motions)
      motion.push_back(0.);
    if (!grid.is_free(0, i))
      continue;
    const unsigned int c = i % dim;
    motions[c].back() = 1.;
    unsigned int motion = dim;
    for (unsigned int j = 0; j < dim; ++j)
      for (unsigned int k = j + 1; k < dim; ++k, ++motion) // turn the axis j towards k
        if (c == j || c == k) {
          const unsigned int other = j + k - c;
          motions[motion].back() = (c == k ? 1. : -1.) * (position(i - c + other) - centre[other]);
        }
  }
}

template class LowOrder<2>;
template class LowOrder<3>;

} // namespace thelma
