#include <thelma/fields/nodal_quadrature.h>

#include <deal.II/fe/fe_values.h>

namespace thelma
{

template <int dim>
void add_nodal_integrals(
    const DofLayout<dim>& layout, const Field field,
    const std::function<double(const Cell<dim>&, const dealii::Point<dim>&)>& density,
    BlockVector& nodal)
{
  dealii::FEValues<dim> values(layout.mapping(), layout.scalar_element(), nodal_rule<dim>(layout),
                               dealii::update_values | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
  for (const Cell<dim>& cell : layout.cells()) {
    values.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell.iterator));
    for (unsigned int q = 0; q < values.n_quadrature_points; ++q) {
      const dealii::Point<dim>& X = values.quadrature_point(q);
      const double amount = density(cell, X) * layout.depth(X) * values.JxW(q);
      for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
        nodal(cell.dofs[cell.unknown(a, field)]) += amount * values.shape_value(a, q);
    }
  }
}

template void
add_nodal_integrals(const DofLayout<2>&, Field,
                    const std::function<double(const Cell<2>&, const dealii::Point<2>&)>&,
                    BlockVector&);
template void
add_nodal_integrals(const DofLayout<3>&, Field,
                    const std::function<double(const Cell<3>&, const dealii::Point<3>&)>&,
                    BlockVector&);

} // namespace thelma
