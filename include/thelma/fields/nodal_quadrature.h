#pragma once

#include <thelma/base/error.h>
#include <thelma/fields/outer_faces.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <functional>
#include <string>

namespace thelma
{

/// The quadrature of @p d dimensions whose points are the nodes; but in bodies of revolution at
/// degree 1 Gauss's, which leaves nodes on the axis their share (theory.md, eq. 37).
template <int d, int dim>
dealii::Quadrature<d> nodal_rule(const DofLayout<dim>& layout)
{
  const unsigned int n_points = layout.degree() + 1;
  if (layout.is_axisymmetric() && layout.degree() == 1)
    return dealii::QGauss<d>(n_points);
  return dealii::QGaussLobatto<d>(n_points);
}

/// The component of a density at a point of the undeformed body.
template <int dim>
using Density = std::function<double(unsigned int component, const dealii::Point<dim>&)>;

/// Add to the entries of @p field in @p nodal the integrals of the density that each cell has, if
/// any, times their shape functions by this @p rule; compress(add) comes later.
template <int dim>
void add_integrals(const DofLayout<dim>& layout, const dealii::Quadrature<dim>& rule, Field field,
                   const std::function<Density<dim>(const Cell<dim>&)>& density_of,
                   BlockVector& nodal);

/// Call @p visit(unknown of @p field, part of its area in mm^2, in plane strain mm, point of the
/// undeformed body) for the nodes of each outer face of the surface @p name, by nodal_rule().
/// Throws InputError, with @p place in the sentence, for an unknown name and for a surface inside
/// of the body, for which @p only tells what is allowed outside alone.
template <int dim, typename Visitor>
void for_each_nodal_area(const Mesh<dim>& mesh, const DofLayout<dim>& layout,
                         const std::string& name, const std::string& place, const Field field,
                         const std::string& only, const Visitor& visit)
{
  const unsigned int component = layout[field].component;
  const bool outer = for_each_outer_face(
      mesh, layout, name, place, nodal_rule<dim - 1>(layout), [&](const OuterFace<dim>& face) {
        for (unsigned int a = 0; a < face.values.dofs_per_cell; ++a)
          for (unsigned int q = 0; q < face.values.n_quadrature_points; ++q)
            if (const double area = face.area(q) * face.values.shape_value(a, q);
                std::abs(area) > 0.)
              visit(face.unknown(a, component), area, face.values.quadrature_point(q));
      });
  if (!outer)
    throw InputError(place + ": '" + name + "' is no outer surface of the body; " + only);
}

} // namespace thelma
