#include <thelma/assembly/p1_coarse_spaces.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <cmath>

namespace thelma
{

template <int dim>
P1CoarseSpaces<dim>::P1CoarseSpaces(const DofLayout<dim>& layout,
                                    const BoundaryConditions<dim>& conditions, const State& state)
    : layout(layout), state(state), corners(layout.new_vector())
{
  for (unsigned int block = 0; block < (layout.has(Field::potential) ? 2 : 1); ++block)
    grids.emplace_back(layout, conditions, block);
  find_corners();
  const dealii::FE_Q<dim> linear(1);
  const dealii::QGauss<dim> rule(2);
  for (unsigned int q = 0; q < n_corners; ++q)
    for (unsigned int v = 0; v < n_corners; ++v) {
      reference_values[q][v] = linear.shape_value(v, rule.point(q));
      reference_gradients[q][v] = linear.shape_grad(v, rule.point(q));
    }
}

template <int dim>
void P1CoarseSpaces<dim>::find_corners()
{
  for (const Cell<dim>& cell : layout.cells())
    for (std::size_t v = 0; v < n_corners; ++v)
      for (int c = 0; c < dim; ++c)
        corners.block(0).local_element(cell.local[v * cell.n_components + c]) =
            cell.iterator->vertex(v)[c];
  corners.update_ghost_values();
}

template <int dim>
void P1CoarseSpaces<dim>::update()
{
  for (P1CoarseSpace<dim>& grid : grids)
    grid.clear();
  for (const Cell<dim>& cell : layout.cells()) {
    Positions x;
    for (std::size_t v = 0; v < n_corners; ++v)
      for (int c = 0; c < dim; ++c) {
        const unsigned int i = cell.local[v * cell.n_components + c];
        x[v][c] = corners.block(0).local_element(i) + state.x.block(0).local_element(i);
      }
    const double theta = cell_temperature(layout, state, cell);
    add(cell, x, cell.material->shear_modulus(theta), cell.material->permittivity(theta));
  }
  for (P1CoarseSpace<dim>& grid : grids)
    grid.finish();
  find_motions();
}

template <int dim>
void P1CoarseSpaces<dim>::add(const Cell<dim>& cell, const Positions& x, const double mu,
                              const double eps)
{
  constexpr std::size_t n = n_corners * dim;
  std::array<double, n * n> shear{};
  std::array<double, n_corners * n_corners> electric{};
  for (const Point& point : points(x))
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
        shear[a * dim * n + b * dim] += 2. * mu * point.weight * point.around[a] * point.around[b];
      }
  grids[0].add(cell, shear.data());
  if (grids.size() > 1)
    grids[1].add(cell, electric.data());
}

template <int dim>
std::array<typename P1CoarseSpaces<dim>::Point, P1CoarseSpaces<dim>::n_corners>
P1CoarseSpaces<dim>::points(const Positions& x) const
{
  const double weight = 1. / n_corners; // of a point of the unit cell
  std::array<Point, n_corners> result;
  for (unsigned int q = 0; q < n_corners; ++q) {
    dealii::Tensor<2, dim> jacobian;
    dealii::Point<dim> here;
    for (unsigned int v = 0; v < n_corners; ++v)
      here += reference_values[q][v] * x[v];
    for (unsigned int v = 0; v < n_corners; ++v)
      jacobian += dealii::outer_product(x[v], reference_gradients[q][v]);
    const double det = dealii::determinant(jacobian);
    const dealii::Tensor<2, dim> inverse = dealii::transpose(dealii::invert(jacobian));
    for (unsigned int v = 0; v < n_corners; ++v) {
      result[q].gradients[v] = inverse * reference_gradients[q][v];
      result[q].around[v] = layout.curvature(here) * reference_values[q][v];
    }
    result[q].weight = std::abs(det * layout.depth(here)) * weight;
  }
  return result;
}

template <int dim>
CoarseGrid P1CoarseSpaces<dim>::of_block(const unsigned int block) const
{
  if (block >= grids.size())
    return {};
  return {&grids[block].matrix(), &grids[block].prolongation(), block > 0};
}

/// Translations and rotations of the deformed body about the middle of its corners.
template <int dim>
void P1CoarseSpaces<dim>::find_motions()
{
  const P1CoarseSpace<dim>& grid = grids[0];
  const std::size_t n_all = corners.block(0).locally_owned_size();
  const auto position = [&](const std::size_t i) {
    return corners.block(0).local_element(i) + state.x.block(0).local_element(i);
  };
  std::vector<double> own(dim, 0.), centre(dim);
  for (std::size_t i = 0; i < n_all; ++i)
    if (grid.is_corner(i))
      own[i % dim] += position(i);
  dealii::Utilities::MPI::sum(own, layout.communicator(), centre);
  for (double& value : centre)
    value *= static_cast<double>(dim) / static_cast<double>(grid.matrix().m());

  motions.assign(dim * (dim + 1) / 2, {});
  for (std::size_t i = 0; i < n_all; ++i) {
    if (!grid.is_corner(i))
      continue;
    for (auto& motion : motions)
      motion.push_back(0.);
    if (!grid.is_free(i))
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

template class P1CoarseSpaces<2>;
template class P1CoarseSpaces<3>;

} // namespace thelma
