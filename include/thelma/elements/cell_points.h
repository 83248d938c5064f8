#pragma once

#include <thelma/elements/contractions.h>
#include <thelma/elements/formulation.h>

#include <algorithm>
#include <vector>

namespace thelma
{

/// What the nodal values @p x of a cell give at one point: the state of plane strain (dim = 2:
/// F_22 = 1, no field or flux out of plane), of a body of revolution (F_22 = 1 + u_1/R) or of
/// space.
template <int dim>
PointInput<double> point_input(const CellView<dim>& view, const NodalValues<dim>& x,
                               const Gradients<dim>& gradients)
{
  PointInput<double> input;
  for (unsigned int i = 0; i < 3; ++i)
    input.state.F[i][i] = 1.;
  const unsigned int phi = view.cell.component(Field::potential),
                     theta = view.cell.component(Field::temperature);
  input.state.theta = view.has_temperature ? x.value(gradients)[theta] : view.theta;
  const auto gradient = x.gradient(gradients);
  for (int J = 0; J < gradients.n_directions(); ++J)
    for (int i = 0; i < dim; ++i)
      if (stretches<dim>(i, J))
        input.state.F[row_of_F<dim>(i, J)][axis<dim>(J)] += gradient[J][i];
  for (int J = 0; J < dim; ++J) {
    if (view.cell.has_potential)
      input.state.E[axis<dim>(J)] = -gradient[J][phi];
    if (view.has_temperature)
      input.grad_theta[axis<dim>(J)] = gradient[J][theta];
  }
  return input;
}

/// Put the numbers of @p point into @p lane.
inline void set_lane(PointInput<Lanes>& all, const unsigned int lane,
                     const PointInput<double>& point)
{
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int J = 0; J < 3; ++J)
      all.state.F[i][J].set(lane, point.state.F[i][J]);
    all.state.E[i].set(lane, point.state.E[i]);
    all.grad_theta[i].set(lane, point.grad_theta[i]);
  }
  all.state.theta.set(lane, point.state.theta);
}

/// The state at one point of a cell, for whatever looks at points without assembling.
template <int dim>
PointState<> point_state(const CellView<dim>& view, const Gradients<dim>& gradients)
{
  const NodalValues<dim> x(view.x, gradients.n_nodes, view.cell.n_components);
  return point_input(view, x, gradients).state;
}

/// The deformation gradient alone, which depends on nothing but the nodal values @p x.
template <int dim>
Tensor3<2> deformation_gradient(const Cell<dim>& cell, const double* x,
                                const Gradients<dim>& gradients)
{
  return point_state(CellView<dim>{0, cell, x, nullptr, 0., false}, gradients).F;
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
      : n_points(rule.basis().n_points), geometry(rule.of_cell(view.index)), memory(view.memory)
  {
    const NodalValues<dim> x(view.x, rule.basis().n_nodes, view.cell.n_components);
    for (unsigned int q = 0; q < n_points; ++q) {
      gradients[q].set(rule.basis(), q, geometry[q]);
      enhance(q, gradients[q]);
      set_lane(input[q / Lanes::n], q % Lanes::n, point_input(view, x, gradients[q]));
    }
    for (unsigned int q = n_points; q % Lanes::n != 0; ++q) // lanes that belong to no point
      set_lane(input[q / Lanes::n], q % Lanes::n, point_input(view, x, gradients[n_points - 1]));
    if (memory.steps)
      set_histories(view.cell.material->n_step());
    for (unsigned int k = 0; k < n_batches(); ++k)
      kinematics[k] = Kinematics<Lanes>(input[k].state.F);
    for (unsigned int q = 0; q < n_points; ++q)
      min_det_F = std::min(min_det_F, J(q));
  }

  CellPoints(const CellPoints&) = delete; // the states refer to what they remember
  CellPoints& operator=(const CellPoints&) = delete;

  unsigned int n_batches() const { return (n_points + Lanes::n - 1) / Lanes::n; }

  PointInput<double> at(const unsigned int q) const
  {
    const PointInput<Lanes>& all = input[q / Lanes::n];
    const unsigned int lane = q % Lanes::n;
    PointInput<double> point;
    for (unsigned int i = 0; i < 3; ++i) {
      for (unsigned int J = 0; J < 3; ++J)
        point.state.F[i][J] = all.state.F[i][J][lane];
      point.state.E[i] = all.state.E[i][lane];
      point.grad_theta[i] = all.grad_theta[i][lane];
    }
    point.state.theta = all.state.theta[lane];
    point.state.history = memory.at(q);
    return point;
  }
  PointState<> state(const unsigned int q) const { return at(q).state; }
  double theta(const unsigned int q) const { return input[q / Lanes::n].state.theta[q % Lanes::n]; }
  double J(const unsigned int q) const { return kinematics[q / Lanes::n].J[q % Lanes::n]; }
  double G(const unsigned int q, const int i, const int J) const
  {
    return kinematics[q / Lanes::n].G[i][J][q % Lanes::n];
  }

  static constexpr unsigned int max = Basis<dim>::max_points;
  unsigned int n_points;
  const PointGeometry<dim>* geometry;
  std::array<Gradients<dim>, max> gradients;
  static constexpr unsigned int max_batches = (max + Lanes::n - 1) / Lanes::n;
  std::array<PointInput<Lanes>, max_batches> input; ///< one point in each lane
  std::array<Kinematics<Lanes>, max_batches> kinematics;
  double min_det_F = std::numeric_limits<double>::max();

private:
  /// The @p n numbers of the step of each point in its lane.
  void set_histories(const unsigned int n)
  {
    steps.resize(std::size_t(n_batches()) * n);
    for (unsigned int k = 0; k < n_batches(); ++k) {
      Lanes* values = steps.data() + std::size_t(k) * n;
      for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
        const double* own = memory.at(std::min(k * Lanes::n + lane, n_points - 1)).step;
        for (unsigned int i = 0; i < n; ++i)
          values[i].set(lane, own[i]);
      }
      input[k].state.history = {values};
    }
  }

  CellMemory memory;
  std::vector<Lanes> steps; ///< of each batch of points; empty where nothing flows
};

/// What the law of a cell remembers after a step to @p view.
template <int dim>
void update_memory(const CellPoints<dim>& points, const CellView<dim>& view, double* now)
{
  for (unsigned int q = 0; q < points.n_points; ++q, now += view.memory.n)
    view.cell.material->update_history(points.state(q), now);
}

/// The integral over one cell of @p density(material, point state).
template <int dim, typename Density>
Energies integral(const CellPoints<dim>& points, const CellView<dim>& view, const Density& density)
{
  Energies sum;
  for (unsigned int q = 0; q < points.n_points; ++q)
    sum.add(points.geometry[q].JxW, density(*view.cell.material, points.state(q)));
  return sum;
}

} // namespace thelma
