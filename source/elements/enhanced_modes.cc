#include <thelma/elements/enhanced_modes.h>

#include <cmath>

namespace thelma
{
namespace
{

/// Multiply the displacement of each mode by @p A.
template <int dim>
void transform(const CellView<dim>& view, const dealii::Tensor<2, dim>& A, double* alpha)
{
  for (int k = 0; k < dim; ++k, alpha += view.cell.n_components) {
    dealii::Tensor<1, dim> a;
    for (int i = 0; i < dim; ++i)
      a[i] = alpha[i];
    a = A * a;
    for (int i = 0; i < dim; ++i)
      alpha[i] = a[i];
  }
}

} // namespace

template <int dim>
EnhancedModes<dim>::EnhancedModes(const DofLayout<dim>& layout) : centre(layout, 1)
{
  const Integration<dim> rule(layout, 2);
  for (std::size_t cell = 0; cell < layout.cells().size(); ++cell)
    add_slopes(*centre.of_cell(cell), rule.quadrature(), rule.of_cell(cell));
}

/// (j_0 / j) times the slope of xi_k^2/2 - m_k xi_k on the cell, j_0 and the Jacobian being those
/// of the centre and m_k the mean of xi_k, in a body of revolution over its circles: int Grad M_k
/// dV = 0.
template <int dim>
void EnhancedModes<dim>::add_slopes(const PointGeometry<dim>& centre,
                                    const dealii::Quadrature<dim>& rule,
                                    const PointGeometry<dim>* points)
{
  const auto radius = [](const PointGeometry<dim>& point) {
    return point.curvature > 0. ? 1. / point.curvature : 1.;
  };
  dealii::Tensor<1, dim> mean;
  double sum = 0.;
  for (unsigned int q = 0; q < n_points; ++q) {
    for (int k = 0; k < dim; ++k)
      mean[k] += radius(points[q]) * (2. * rule.point(q)[k] - 1.);
    sum += radius(points[q]);
  }
  mean /= sum;
  const double j_0 = centre.JxW / radius(centre);
  for (unsigned int q = 0; q < n_points; ++q) {
    const double ratio = j_0 * rule.weight(q) * radius(points[q]) / points[q].JxW;
    slopes.emplace_back();
    for (int k = 0; k < dim; ++k)
      for (int J = 0; J < dim; ++J)
        slopes.back()[J][k] =
            ratio * (2. * rule.point(q)[k] - 1. - mean[k]) * centre.inverse_jacobian[k][J];
  }
}

template <int dim>
double EnhancedModes<dim>::squared_norm(const std::size_t cell, const int k) const
{
  const double volume = centre.of_cell(cell)->JxW;
  double sum = 0.;
  for (unsigned int q = 0; q < n_points; ++q)
    for (int J = 0; J < dim; ++J)
      sum += std::pow(slopes[cell * n_points + q][J][k], 2) * volume / n_points;
  return sum;
}

template <int dim>
void EnhancedModes<dim>::pull_back(const CellView<dim>& view, double* alpha) const
{
  transform(view, dealii::invert(centre_gradient(view)), alpha);
}

template <int dim>
void EnhancedModes<dim>::push_forward(const CellView<dim>& view, double* alpha) const
{
  transform(view, centre_gradient(view), alpha);
}

/// F at the centre, where the modes vanish.
template <int dim>
dealii::Tensor<2, dim> EnhancedModes<dim>::centre_gradient(const CellView<dim>& view) const
{
  const Gradients<dim> gradients(centre.basis(), 0, *centre.of_cell(view.index));
  const PointState<> state = point_state(view, gradients);
  dealii::Tensor<2, dim> F;
  for (int i = 0; i < dim; ++i)
    for (int J = 0; J < dim; ++J)
      F[i][J] = state.F[axis<dim>(i)][axis<dim>(J)];
  return F;
}

template class EnhancedModes<2>;
template class EnhancedModes<3>;

} // namespace thelma
