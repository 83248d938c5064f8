#include <thelma/base/error.h>
#include <thelma/fields/deformed_surface.h>
#include <thelma/fields/outer_faces.h>

#include <deal.II/base/quadrature_lib.h>

#include <map>

namespace thelma
{

/// The rule of p + 1 points integrates eq. (74) exactly on faces that are polynomials of degree p.
template <int dim>
void DeformedSurface<dim>::setup(const Mesh<dim>& mesh, const DofLayout<dim>& layout,
                                 const std::string& name, const std::string& place)
{
  using namespace dealii;
  std::map<unsigned int, std::size_t> own;
  for (const Cell<dim>& cell : layout.cells())
    own[cell.iterator->active_cell_index()] = own.size();
  FEFaceValues<dim> values(layout.mapping(), layout.scalar_element(),
                           QGauss<dim - 1>(layout.degree() + 1),
                           update_values | update_gradients | update_JxW_values |
                               update_normal_vectors | update_quadrature_points);
  const bool outer =
      visit_outer_faces(mesh, name, place, [&](const auto& entity, const unsigned int f) {
        values.reinit(entity, f);
        Face face{own.at(entity->active_cell_index()), nullptr, {}};
        face.cell = &layout.cells()[face.index];
        for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
          if (layout.scalar_element().has_support_on_face(a, f))
            face.nodes.push_back(a);
        points.emplace_back();
        for (const unsigned int q : values.quadrature_point_indices()) {
          Undeformed point{
              values.JxW(q), values.quadrature_point(q), values.normal_vector(q), {}, {}};
          for (const unsigned int a : face.nodes)
            point.shape.push_back(values.shape_value(a, q));
          for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
            point.gradients.push_back(values.shape_grad(a, q));
          points.back().push_back(point);
        }
        faces.push_back(face);
      });
  if (!outer)
    throw InputError(place + ": '" + name +
                     "' is no outer surface of the body; name one that has the body on one side");
}

template <int dim>
typename DeformedSurface<dim>::Point
DeformedSurface<dim>::deform(const DofLayout<dim>& layout, const Face& face,
                             const Undeformed& point, const std::vector<double>& values)
{
  const unsigned int n_c = face.cell->n_components;
  dealii::Tensor<2, dim> F = dealii::unit_symmetric_tensor<dim>();
  for (std::size_t a = 0; a < point.gradients.size(); ++a)
    for (int i = 0; i < dim; ++i)
      F[i] += values[a * n_c + i] * point.gradients[a];
  const dealii::Tensor<2, dim> G = dealii::transpose(dealii::invert(F));
  Point result{
      point.X, point.JxW * dealii::determinant(F) * (G * point.normal), 0., point.shape, {}};
  for (std::size_t a = 0; a < face.nodes.size(); ++a) {
    for (int i = 0; i < dim; ++i)
      result.x[i] += point.shape[a] * values[face.unknown(a, i)];
    result.gradients.push_back(G * point.gradients[face.nodes[a]]);
  }
  result.area *= layout.depth(result.x);
  result.curvature = layout.curvature(result.x);
  return result;
}

template <int dim>
double DeformedSurface<dim>::own_volume(const DofLayout<dim>& layout, const BlockVector& x) const
{
  double volume = 0.;
  visit(layout, x, [&](const Face&, const std::vector<Point>& deformed) {
    for (const Point& point : deformed)
      volume += point.x * point.area / layout.n_sizes();
  });
  return volume;
}

template class DeformedSurface<2>;
template class DeformedSurface<3>;

} // namespace thelma
