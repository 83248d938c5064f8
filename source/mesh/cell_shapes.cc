#include <thelma/mesh/cell_shapes.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// The middle of @p mask in @p cell, nullptr if it has none.
template <int dim>
const dealii::Point<dim>* middle(const dealii::CellData<dim>& cell, const std::uint8_t mask,
                                 const Middles<dealii::Point<dim>>& middles)
{
  const auto found = middles.find(sorted_vertices<dim>(cell, mask));
  return found == middles.end() ? nullptr : &found->second;
}

} // namespace

template <int dim>
std::uint8_t face_vertices(const unsigned int f)
{
  using Geometry = dealii::GeometryInfo<dim>;
  std::uint8_t mask = 0;
  for (unsigned int v = 0; v < Geometry::vertices_per_face; ++v)
    mask |= 1u << Geometry::face_to_cell_vertices(f, v);
  return mask;
}

template <int dim>
std::vector<unsigned int> sorted_vertices(const dealii::CellData<dim>& cell,
                                          const std::uint8_t mask)
{
  std::vector<unsigned int> result;
  for (unsigned int v = 0; v < cell.vertices.size(); ++v)
    if (mask & (1u << v))
      result.push_back(cell.vertices[v]);
  std::sort(result.begin(), result.end());
  return result;
}

template <int dim>
void turn_negative(const std::vector<dealii::Point<dim>>& vertices,
                   std::vector<dealii::CellData<dim>>& cells)
{
  for (dealii::CellData<dim>& cell : cells) {
    std::vector<unsigned int>& corners = cell.vertices;
    if (dealii::GridTools::cell_measure<dim>(vertices, corners) >= 0.)
      continue;
    if (dim == 2)
      std::swap(corners[1], corners[2]);
    else
      for (const unsigned int v : {0, 1, 4, 5})
        std::swap(corners[v], corners[v + 2]);
  }
}

/// With E and V the sums over the edges and vertices of a face or a cell of dimension d, a
/// serendipity element has the middle E/2 - V/4 of a face and (E - V)/4 of a hexahedron.
template <int dim>
std::vector<dealii::Point<dim>> quadratic_nodes(const dealii::CellData<dim>& cell,
                                                const std::vector<dealii::Point<dim>>& vertices,
                                                const Middles<dealii::Point<dim>>& middles)
{
  using Geometry = dealii::GeometryInfo<dim>;
  using Sum = dealii::Tensor<1, dim>;
  std::vector<dealii::Point<dim>> nodes;
  Sum of_vertices, of_edges;
  for (const unsigned int v : cell.vertices) {
    nodes.push_back(vertices[v]);
    of_vertices += vertices[v];
  }
  std::vector<std::uint8_t> edges;
  for (unsigned int l = 0; l < Geometry::lines_per_cell; ++l) {
    const unsigned int a = Geometry::line_to_cell_vertices(l, 0),
                       b = Geometry::line_to_cell_vertices(l, 1);
    edges.push_back((1u << a) | (1u << b));
    const dealii::Point<dim>* known = middle(cell, edges.back(), middles);
    nodes.push_back(known != nullptr ? *known : nodes[a] + (nodes[b] - nodes[a]) / 2.);
    of_edges += nodes.back();
  }
  for (unsigned int f = 0; dim == 3 && f < Geometry::faces_per_cell; ++f) {
    const std::uint8_t face = face_vertices<dim>(f);
    const dealii::Point<dim>* known = middle(cell, face, middles);
    Sum serendipity;
    for (unsigned int l = 0; l < edges.size(); ++l)
      if ((edges[l] & face) == edges[l])
        serendipity += nodes[Geometry::vertices_per_cell + l] / 2.;
    for (unsigned int v = 0; v < Geometry::vertices_per_cell; ++v)
      if (face & (1u << v))
        serendipity -= nodes[v] / 4.;
    nodes.push_back(known != nullptr ? *known : dealii::Point<dim>(serendipity));
  }
  const dealii::Point<dim>* known =
      middle(cell, static_cast<std::uint8_t>((1u << Geometry::vertices_per_cell) - 1), middles);
  nodes.push_back(known != nullptr
                      ? *known
                      : dealii::Point<dim>(of_edges / (dim == 2 ? 2. : 4.) - of_vertices / 4.));
  return nodes;
}

template <int dim>
double shape_of_corners(const std::vector<dealii::Point<dim>>& corners)
{
  constexpr unsigned int n = dealii::GeometryInfo<dim>::vertices_per_cell;
  dealii::Tensor<0, dim> volumes[n];
  dealii::Point<dim> vertices[n];
  std::copy_n(corners.begin(), n, vertices);
  dealii::GeometryInfo<dim>::alternating_form_at_vertices(vertices, volumes);
  double shape = 1.;
  for (unsigned int v = 0; v < n; ++v) {
    double edges = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      edges *= corners[v].distance(corners[v ^ (1u << d)]);
    shape = std::min(shape, edges > 0. ? double(volumes[v]) / edges : 0.);
  }
  return shape;
}

template <int dim>
double shape_of_nodes(const std::vector<dealii::Point<dim>>& nodes)
{
  static const dealii::FE_Q<dim> element(2);
  const std::vector<dealii::Point<dim>>& at = element.get_unit_support_points();
  double shape = 1.;
  for (const dealii::Point<dim>& x : at) {
    dealii::Tensor<2, dim> tangents; // a row each
    for (unsigned int i = 0; i < nodes.size(); ++i)
      tangents += dealii::outer_product(element.shape_grad(i, x), dealii::Tensor<1, dim>(nodes[i]));
    double lengths = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      lengths *= tangents[d].norm();
    shape = std::min(shape, lengths > 0. ? determinant(tangents) / lengths : 0.);
  }
  return shape;
}

template std::uint8_t face_vertices<2>(unsigned int);
template std::vector<unsigned int> sorted_vertices(const dealii::CellData<2>&, std::uint8_t);
template void turn_negative(const std::vector<dealii::Point<2>>&,
                            std::vector<dealii::CellData<2>>&);
template std::vector<dealii::Point<2>> quadratic_nodes(const dealii::CellData<2>&,
                                                       const std::vector<dealii::Point<2>>&,
                                                       const Middles<dealii::Point<2>>&);
template double shape_of_corners(const std::vector<dealii::Point<2>>&);
template double shape_of_nodes(const std::vector<dealii::Point<2>>&);

template std::uint8_t face_vertices<3>(unsigned int);
template std::vector<unsigned int> sorted_vertices(const dealii::CellData<3>&, std::uint8_t);
template void turn_negative(const std::vector<dealii::Point<3>>&,
                            std::vector<dealii::CellData<3>>&);
template std::vector<dealii::Point<3>> quadratic_nodes(const dealii::CellData<3>&,
                                                       const std::vector<dealii::Point<3>>&,
                                                       const Middles<dealii::Point<3>>&);
template double shape_of_corners(const std::vector<dealii::Point<3>>&);
template double shape_of_nodes(const std::vector<dealii::Point<3>>&);

} // namespace thelma
