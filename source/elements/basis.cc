#include <thelma/elements/basis.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace thelma
{

template <int dim>
Basis<dim>::Basis(const dealii::FiniteElement<dim>& scalar, const dealii::Quadrature<dim>& rule,
                  const unsigned int n_enhanced)
    : n_points(rule.size()), n_nodes(scalar.dofs_per_cell + n_enhanced), stride(padded(n_nodes)),
      N(std::size_t(n_points) * stride, 0.), dN(std::size_t(n_points) * dim * stride, 0.)
{
  AssertThrow(n_nodes <= max_nodes && n_points <= max_points, dealii::ExcInternalError());
  for (unsigned int q = 0; q < n_points; ++q)
    for (unsigned int a = 0; a < scalar.dofs_per_cell; ++a) {
      N[q * stride + a] = scalar.shape_value(a, rule.point(q));
      for (unsigned int d = 0; d < dim; ++d)
        dN[(q * dim + d) * stride + a] = scalar.shape_grad(a, rule.point(q))[d];
    }
}

template <int dim>
Integration<dim>::Integration(const DofLayout<dim>& layout, const unsigned int n_points,
                              const unsigned int n_enhanced)
    : rule(dealii::QGauss<dim>(n_points)), shape(layout.scalar_element(), rule, n_enhanced)
{
  using dealii::update_inverse_jacobians;
  using dealii::update_JxW_values;
  using dealii::update_quadrature_points;
  dealii::FEValues<dim> values(layout.mapping(), layout.scalar_element(), rule,
                               update_inverse_jacobians | update_JxW_values |
                                   update_quadrature_points);
  for (const Cell<dim>& cell : layout.cells()) {
    values.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell.iterator));
    for (unsigned int q = 0; q < shape.n_points; ++q) {
      const dealii::Point<dim>& X = values.quadrature_point(q);
      geometry.push_back({dealii::Tensor<2, dim>(values.inverse_jacobian(q)),
                          layout.depth(X) * values.JxW(q), layout.curvature(X)});
    }
  }
}

template struct Basis<2>;
template struct Basis<3>;
template class Integration<2>;
template class Integration<3>;

} // namespace thelma
