#include <thelma/fields/nodal_quadrature.h>

#include <deal.II/fe/fe_values.h>

namespace thelma
{

template <int dim>
void add_integrals(const DofLayout<dim>& layout, const dealii::Quadrature<dim>& rule,
                   const Field field,
                   const std::function<Density<dim>(const Cell<dim>&)>& density_of,
                   BlockVector& nodal)
{
  const unsigned int n_components = layout[field].n_components;
  dealii::FEValues<dim> values(layout.mapping(), layout.scalar_element(), rule,
                               dealii::update_values | dealii::update_JxW_values |
                                   dealii::update_quadrature_points);
  for (const Cell<dim>& cell : layout.cells()) {
    const Density<dim> density = density_of(cell);
    if (!density)
      continue;
    values.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell.iterator));
    for (unsigned int q = 0; q < values.n_quadrature_points; ++q) {
      const dealii::Point<dim>& X = values.quadrature_point(q);
      const double volume = layout.depth(X) * values.JxW(q);
      for (unsigned int c = 0; c < n_components; ++c) {
        const double amount = density(c, X) * volume;
        for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
          nodal(cell.dofs[cell.unknown(a, field) + c]) += amount * values.shape_value(a, q);
      }
    }
  }
}

template void add_integrals(const DofLayout<2>&, const dealii::Quadrature<2>&, Field,
                            const std::function<Density<2>(const Cell<2>&)>&, BlockVector&);
template void add_integrals(const DofLayout<3>&, const dealii::Quadrature<3>&, Field,
                            const std::function<Density<3>(const Cell<3>&)>&, BlockVector&);

} // namespace thelma
