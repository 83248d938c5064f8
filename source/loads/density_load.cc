#include <thelma/base/error.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/parameters.h>
#include <thelma/fields/outer_faces.h>
#include <thelma/loads/density_load.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace thelma
{

template <int dim>
void DensityLoad<dim>::declare(dealii::ParameterHandler& prm)
{
  const Section section(prm, {kind.entry.section});
  add_distributions(prm, kind.entry.name, densities, kind.sentence + ", as `" + kind.example + "`",
                    n_components(), kind.unit);
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
  InputErrors errors;
  for (const auto& density : densities)
    errors.collect([&]() {
      if (kind.on == DensityKind::On::regions)
        require_region(*mesh, density.first, entry().place());
      require_field(density.first);
    });
  errors.raise();
  forces.setup(entry(), *layout, change_in_time(densities),
               [this](const double time, BlockVector& nodal) {
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
  add_integrals<dim>(*layout, dealii::QGauss<dim>(layout->degree() + 1), kind.field,
                     densities_at(time, densities, *mesh, sign()), nodal);
}

template <int dim>
void DensityLoad<dim>::integrate_surfaces(const double time, BlockVector& nodal) const
{
  const unsigned int first = (*layout)[kind.field].component;
  for (const auto& [name, density] : densities)
    for_each_outer_face(
        *mesh, *layout, name, entry().place(), dealii::QGauss<dim - 1>(layout->degree() + 1),
        [&, &density = density](const OuterFace<dim>& face) {
          for (unsigned int q = 0; q < face.values.n_quadrature_points; ++q)
            for (unsigned int c = 0; c < n_components(); ++c) {
              const double amount =
                  sign() * face.area(q) * density(c, face.values.quadrature_point(q), time);
              for (unsigned int a = 0; a < face.values.dofs_per_cell; ++a)
                if (const double part = face.values.shape_value(a, q); std::abs(part) > 0.)
                  nodal(face.unknown(a, first + c)) += amount * part;
            }
        });
}

template class DensityLoad<2>;
template class DensityLoad<3>;

} // namespace thelma
