#include <thelma/base/error.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/parameters.h>
#include <thelma/fields/outer_faces.h>
#include <thelma/loads/density_load.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

namespace thelma
{

template <int dim>
void DensityLoad<dim>::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {kind.entry.section});
  prm.add_parameter(kind.entry.name, texts,
                    kind.sentence + ", as `" + kind.example + "`. " + Distribution<dim>::sentence +
                        ". Unit: " + kind.unit + ".",
                    Map(Anything(), Anything(), 0, 100));
  check_values(prm, kind.entry.name, [this](const std::string& text) {
    Distribution<dim>(text, n_components(), kind.unit);
  });
}

template <int dim>
void DensityLoad<dim>::setup(const LoadInput<dim>& input)
{
  if (!is_present())
    return;
  mesh = &input.mesh;
  layout = &input.layout;
  if (!layout->has(kind.field))
    throw InputError(entry().place() + ": every region is passive, so there is no potential; "
                                       "remove the charges or make a region active");
  bool in_time = false;
  densities.clear();
  InputErrors errors;
  for (const auto& [name, text] : texts)
    errors.collect([&, &name = name, &text = text]() {
      if (kind.on == DensityKind::On::regions)
        require_region(*mesh, name, entry().place());
      require_field(name);
      const Distribution<dim>& density =
          densities.emplace(name, Distribution<dim>(text, n_components(), kind.unit)).first->second;
      in_time = in_time || density.changes_in_time();
    });
  errors.raise();
  forces.setup(entry(), *layout, in_time, [this](const double time, BlockVector& nodal) {
    if (kind.on == DensityKind::On::regions)
      integrate_regions(time, nodal);
    else
      integrate_surfaces(time, nodal);
  });
}

template <int dim>
void DensityLoad<dim>::require_field(const std::string& name) const
{
  bool lacks = false, outer = true;
  if (kind.on == DensityKind::On::regions) {
    for (const Cell<dim>& cell : layout->cells())
      lacks = lacks || (mesh->region_of(cell.iterator) == name && !cell.has_potential);
  } else
    outer = visit_outer_faces(*mesh, name, entry().place(), [&](const auto& cell, unsigned int) {
      lacks = lacks || layout->with_unknowns(cell)->active_fe_index() != 0;
    });
  if (!outer)
    throw InputError(entry().place() + ": '" + name + "' is no outer surface of the body; a " +
                     kind.noun + " can act only on these");
  if (kind.field == Field::potential &&
      dealii::Utilities::MPI::logical_or(lacks, layout->communicator()))
    throw InputError(entry().place() + ": there is no electric field in all of '" + name +
                     "'; take it out of Regions/Passive, or leave out the charge");
}

template <int dim>
void DensityLoad<dim>::integrate_regions(const double time, BlockVector& nodal) const
{
  const double sign = kind.field == Field::potential ? -1. : 1.;
  dealii::FEValues<dim> values(
      layout->mapping(), layout->scalar_element(), dealii::QGauss<dim>(layout->degree() + 1),
      dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points);
  for (const Cell<dim>& cell : layout->cells()) {
    const auto found = densities.find(mesh->region_of(cell.iterator));
    if (found == densities.end())
      continue;
    values.reinit(typename dealii::Triangulation<dim>::active_cell_iterator(cell.iterator));
    for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
      for (unsigned int c = 0; c < n_components(); ++c) {
        const dealii::Point<dim>& X = values.quadrature_point(q);
        const double amount = sign * layout->depth(X) * values.JxW(q) * found->second(c, X, time);
        for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
          nodal(cell.dofs[cell.unknown(a, kind.field) + c]) += amount * values.shape_value(a, q);
      }
  }
}

template <int dim>
void DensityLoad<dim>::integrate_surfaces(const double time, BlockVector& nodal) const
{
  const double sign = kind.field == Field::potential ? -1. : 1.;
  const unsigned int first = (*layout)[kind.field].component;
  for (const auto& [name, density] : densities)
    for_each_outer_face(
        *mesh, *layout, name, entry().place(), dealii::QGauss<dim - 1>(layout->degree() + 1),
        [&, &density = density](const OuterFace<dim>& face) {
          for (unsigned int q = 0; q < face.values.n_quadrature_points; ++q)
            for (unsigned int c = 0; c < n_components(); ++c) {
              const double amount =
                  sign * face.area(q) * density(c, face.values.quadrature_point(q), time);
              for (unsigned int a = 0; a < face.values.dofs_per_cell; ++a)
                if (const double part = face.values.shape_value(a, q); std::abs(part) > 0.)
                  nodal(face.unknown(a, first + c)) += amount * part;
            }
        });
}

template class DensityLoad<2>;
template class DensityLoad<3>;

} // namespace thelma
