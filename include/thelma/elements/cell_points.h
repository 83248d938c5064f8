#pragma once

#include <thelma/elements/contractions.h>
#include <thelma/elements/formulation.h>

#include <algorithm>

namespace thelma
{

/// What the nodal values @p x of a cell give at one point: the state of plane strain (dim = 2:
/// F_22 = 1, no field or flux out of plane) or of space.
template <int dim>
PointInput point_input(const CellView<dim>& view, const NodalValues<dim>& x,
                       const Gradients<dim>& gradients)
{
  PointInput input;
  for (unsigned int i = 0; i < 3; ++i)
    input.state.F[i][i] = 1.;
  const unsigned int last = x.n_components - 1;
  input.state.theta = view.has_temperature ? x.value(last, gradients) : view.theta;
  for (int J = 0; J < dim; ++J) {
    for (int i = 0; i < dim; ++i)
      input.state.F[axis<dim>(i)][axis<dim>(J)] += x.gradient(i, J, gradients);
    if (view.cell.has_potential)
      input.state.E[axis<dim>(J)] = -x.gradient(dim, J, gradients);
    if (view.has_temperature)
      input.grad_theta[axis<dim>(J)] = x.gradient(last, J, gradients);
  }
  return input;
}

/// The state at one point of a cell, for whatever looks at points without assembling.
template <int dim>
PointState<> point_state(const CellView<dim>& view, const Gradients<dim>& gradients)
{
  const NodalValues<dim> x(view.x, gradients.n_nodes, view.cell.n_components);
  return point_input(view, x, gradients).state;
}

/// Everything the formulations need to know of the points of one rule in a cell.
template <int dim>
struct CellPoints {
  CellPoints(const Integration<dim>& rule, const CellView<dim>& view)
      : CellPoints(rule, view, [](unsigned int, Gradients<dim>&) {})
  {
  }

  /// @p enhance(q, gradients) sets the gradients of modes that are no shape functions.
  template <typename Enhance>
  CellPoints(const Integration<dim>& rule, const CellView<dim>& view, const Enhance& enhance)
      : n_points(rule.basis().n_points), geometry(rule.of_cell(view.index))
  {
    const NodalValues<dim> x(view.x, rule.basis().n_nodes, view.cell.n_components);
    for (unsigned int q = 0; q < n_points; ++q) {
      gradients[q] = Gradients<dim>(rule.basis(), q, geometry[q]);
      enhance(q, gradients[q]);
      input[q] = point_input(view, x, gradients[q]);
      kinematics[q] = Kinematics<>(input[q].state.F);
      min_det_F = std::min(min_det_F, kinematics[q].J);
    }
  }

  static constexpr unsigned int max = Basis<dim>::max_points;
  unsigned int n_points;
  const PointGeometry<dim>* geometry;
  std::array<Gradients<dim>, max> gradients;
  std::array<PointInput, max> input;
  std::array<Kinematics<>, max> kinematics;
  double min_det_F = std::numeric_limits<double>::max();
};

/// The integral over one cell of @p density(material, point state).
template <int dim, typename Density>
Energies integral(const CellPoints<dim>& points, const CellView<dim>& view, const Density& density)
{
  Energies sum;
  for (unsigned int q = 0; q < points.n_points; ++q)
    sum.add(points.geometry[q].JxW, density(*view.cell.material, points.input[q].state));
  return sum;
}

} // namespace thelma
