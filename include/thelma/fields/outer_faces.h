#pragma once

#include <thelma/fields/dof_layout.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <vector>

namespace thelma
{

/// One face of a named surface, integrated over.
template <int dim>
struct OuterFace {
  const dealii::FEFaceValues<dim>& values; ///< of the scalar element: JxW and shape functions
  const DofLayout<dim>& layout;
  const std::vector<dealii::types::global_dof_index>& indices; ///< of its cell
  unsigned int fe_index;

  /// The unknown of @p component at the cell's node @p a.
  dealii::types::global_dof_index unknown(const unsigned int a, const unsigned int component) const
  {
    return indices[*layout.local_dof(fe_index, a, component)];
  }
};

/// Call @p visit(cell, number of the face) for every face of the surface @p name at the boundary of
/// the body on a cell of this rank; whether there is one on any rank. Throws InputError, with @p
/// place in the sentence, for an unknown name.
template <int dim, typename Visitor>
bool visit_outer_faces(const Mesh<dim>& mesh, const std::string& name, const std::string& place,
                       const Visitor& visit)
{
  bool outer = false;
  for (const auto& [cell, vertices] : mesh.surface(name, place))
    for (unsigned int f = 0; f < dealii::GeometryInfo<dim>::faces_per_cell; ++f)
      if (face_vertices<dim>(f) == vertices && cell->face(f)->at_boundary()) {
        outer = true;
        visit(cell, f);
      }
  return dealii::Utilities::MPI::logical_or(outer, mesh.communicator());
}

/// visit_outer_faces() with @p visit(OuterFace).
template <int dim, typename Visitor>
bool for_each_outer_face(const Mesh<dim>& mesh, const DofLayout<dim>& layout,
                         const std::string& name, const std::string& place,
                         const dealii::Quadrature<dim - 1>& quadrature, const Visitor& visit)
{
  dealii::FEFaceValues<dim> values(layout.mapping(), layout.scalar_element(), quadrature,
                                   dealii::update_values | dealii::update_JxW_values |
                                       dealii::update_quadrature_points);
  std::vector<dealii::types::global_dof_index> indices;
  return visit_outer_faces(mesh, name, place, [&](const auto& entity, const unsigned int f) {
    const auto cell = layout.with_unknowns(entity);
    layout.unknowns(cell, indices);
    values.reinit(entity, f);
    visit(OuterFace<dim>{values, layout, indices, cell->active_fe_index()});
  });
}

} // namespace thelma
