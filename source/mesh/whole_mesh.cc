#include <thelma/base/axes.h>
#include <thelma/base/error.h>
#include <thelma/base/formula.h>
#include <thelma/mesh/whole_mesh.h>

#include <deal.II/base/patterns.h>
#include <deal.II/grid/grid_tools.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <cstdio>
#include <list>
#include <numeric>

namespace thelma
{

namespace
{

using VertexSet = std::vector<unsigned int>;

/// The sets of local vertices that make the faces, lines (3-D) and vertices of a cell.
template <int dim>
std::vector<std::uint8_t> entities_of_a_cell()
{
  using Geometry = dealii::GeometryInfo<dim>;
  std::vector<std::uint8_t> masks;
  for (unsigned int f = 0; f < Geometry::faces_per_cell; ++f)
    masks.push_back(face_vertices<dim>(f));
  if constexpr (dim == 3)
    for (unsigned int l = 0; l < Geometry::lines_per_cell; ++l)
      masks.push_back((1u << Geometry::line_to_cell_vertices(l, 0)) |
                      (1u << Geometry::line_to_cell_vertices(l, 1)));
  for (unsigned int v = 0; v < Geometry::vertices_per_cell; ++v)
    masks.push_back(1u << v);
  return masks;
}

/// Throws InputError unless every face belongs to one cell or two different ones.
template <int dim>
void require_neighbours(const std::vector<dealii::CellData<dim>>& cells)
{
  std::map<VertexSet, std::vector<VertexSet>> cells_of_face;
  for (const dealii::CellData<dim>& cell : cells) {
    const VertexSet all = sorted_vertices<dim>(cell, 0xff);
    for (unsigned int f = 0; f < dealii::GeometryInfo<dim>::faces_per_cell; ++f) {
      std::vector<VertexSet>& owners =
          cells_of_face[sorted_vertices<dim>(cell, face_vertices<dim>(f))];
      if (owners.size() == 2 || std::find(owners.begin(), owners.end(), all) != owners.end())
        throw InputError(
            "section Mesh, entry 'File': cells overlap, more than two share a face; assign every "
            "cell to one named region, once");
      owners.push_back(all);
    }
  }
}

template <int dim>
dealii::Point<dim> point(const std::array<double, 3>& X)
{
  dealii::Point<dim> result;
  for (unsigned int d = 0; d < dim; ++d)
    result[d] = X[axis<dim>(d)];
  return result;
}

/// The root of a tree of vertices, with the way to it made short.
unsigned int root(VertexSet& parent, unsigned int v)
{
  while (parent[v] != v)
    v = parent[v] = parent[parent[v]];
  return v;
}

} // namespace

template <int dim>
WholeMesh<dim>::WholeMesh(const CoarseMesh& coarse) : vertices(coarse.vertices.size())
{
  // gmsh counts the vertices of a quadrilateral around it, deal.II row by row.
  const std::array<unsigned int, 8> order{{0, 1, 3, 2, 4, 5, 7, 6}};
  for (std::size_t v = 0; v < vertices.size(); ++v)
    vertices[v] = point<dim>(coarse.vertices[v]);
  find_middles(coarse);
  for (const PhysicalGroup& group : coarse.groups)
    if (group.dimension == dim) {
      for (const auto& element : group.elements) {
        dealii::CellData<dim> cell;
        for (unsigned int v = 0; v < element.size(); ++v)
          cell.vertices[v] = element[order[v]];
        cell.material_id = known.regions.size();
        cells.push_back(cell);
      }
      known.regions.push_back(group.name);
    }
  turn_negative(vertices, cells);
  check_shapes("");
  require_neighbours<dim>(cells);
  dealii::GridTools::consistently_order_cells(cells);
  find_bodies();
  find_surfaces(coarse);
}

/// None if all edges are straight.
template <int dim>
void WholeMesh<dim>::find_middles(const CoarseMesh& coarse)
{
  bool is_straight = true;
  for (const auto& [corners, X] : coarse.middles) {
    const dealii::Point<dim> middle = point<dim>(X);
    dealii::Tensor<1, dim> sum;
    for (const unsigned int v : corners)
      sum += vertices[v];
    const double length = vertices[corners.front()].distance(vertices[corners.back()]);
    is_straight =
        is_straight && (middle - sum / static_cast<double>(corners.size())).norm() < 1e-9 * length;
    middles.emplace(corners, middle);
  }
  if (is_straight)
    middles.clear();
}

/// Numbers the bodies as the cells come to them, and the parts, so far regions, anew.
template <int dim>
void WholeMesh<dim>::find_bodies()
{
  VertexSet body_of_vertex(vertices.size());
  std::iota(body_of_vertex.begin(), body_of_vertex.end(), 0);
  for (const dealii::CellData<dim>& cell : cells)
    for (const unsigned int v : cell.vertices)
      body_of_vertex[root(body_of_vertex, v)] = root(body_of_vertex, cell.vertices[0]);
  std::map<unsigned int, unsigned int> bodies;
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> parts;
  for (dealii::CellData<dim>& cell : cells) {
    const unsigned int region = cell.material_id,
                       body = bodies.emplace(root(body_of_vertex, cell.vertices[0]), bodies.size())
                                  .first->second;
    const auto [part, is_new] = parts.emplace(std::pair(region, body), parts.size());
    if (is_new)
      known.parts.push_back({region, body});
    cell.material_id = part->second;
  }
}

template <int dim>
void WholeMesh<dim>::find_surfaces(const CoarseMesh& coarse)
{
  std::map<VertexSet, std::vector<std::string>> groups_of;
  for (const PhysicalGroup& group : coarse.groups)
    if (group.dimension < dim) {
      known.surfaces[group.name];
      for (VertexSet element : group.elements) {
        std::sort(element.begin(), element.end());
        groups_of[element].push_back(group.name);
      }
    }
  const std::vector<std::uint8_t> masks = entities_of_a_cell<dim>();
  for (unsigned int number = 0; number < cells.size(); ++number)
    for (const std::uint8_t mask : masks) {
      const auto found = groups_of.find(sorted_vertices<dim>(cells[number], mask));
      if (found != groups_of.end())
        for (const std::string& name : found->second)
          known.surfaces[name].push_back({number, mask});
    }
}

template <int dim>
void WholeMesh<dim>::displace(const double amplitude, const std::vector<std::string>& expressions)
{
  const std::string place = "section Mesh, entry 'Imperfection shape'";
  if (expressions.size() != 3)
    throw InputError(place + ": an imperfection needs three expressions separated by ';', " +
                     std::to_string(expressions.size()) + " given");
  std::list<Formula<3>> formulas;
  for (int c = 0; c < dim; ++c)
    formulas.emplace_back(place, expressions[axis<dim>(c)], "x1,x2,x3");
  const auto move = [&](dealii::Point<dim>& x) {
    dealii::Point<3> X;
    for (int d = 0; d < dim; ++d)
      X[axis<dim>(d)] = x[d];
    int c = 0;
    for (const Formula<3>& shape : formulas)
      x[c++] += amplitude * shape(X);
  };
  std::for_each(vertices.begin(), vertices.end(), move);
  for (auto& middle : middles)
    move(middle.second);
  check_shapes("section Mesh, entry 'Imperfection': the amplitude of " +
               dealii::Patterns::Tools::to_string(amplitude) +
               " mm inverts a cell; choose a smaller one or a smoother shape");
}

template <int dim>
double WholeMesh<dim>::shape_of(const dealii::CellData<dim>& cell) const
{
  if (is_quadratic())
    return shape_of_nodes(nodes_of(cell));
  std::vector<dealii::Point<dim>> corners;
  for (const unsigned int v : cell.vertices)
    corners.push_back(vertices[v]);
  return shape_of_corners(corners);
}

/// A cell is sound as long as its Jacobian is positive at every vertex, or node.
template <int dim>
void WholeMesh<dim>::check_shapes(const std::string& complaint)
{
  known.worst_shape = 1.;
  unsigned int n_bad = 0;
  const dealii::CellData<dim>* bad = nullptr;
  for (const dealii::CellData<dim>& cell : cells) {
    const double shape = shape_of(cell);
    known.worst_shape = std::min(known.worst_shape, shape);
    if (!(shape > 1e-6)) {
      ++n_bad;
      bad = bad == nullptr ? &cell : bad;
    }
  }
  if (n_bad > 0)
    throw InputError(!complaint.empty()
                         ? complaint
                         : "section Mesh, entry 'File': " + std::to_string(n_bad) + " of " +
                               std::to_string(cells.size()) +
                               " cells are flat or inverted, one of them in the region '" +
                               known.regions[bad->material_id] + "' at " +
                               dealii::Patterns::Tools::to_string(vertices[bad->vertices[0]]) +
                               " mm; correct the geometry or its parameters");
}

template <int dim>
unsigned int WholeMesh<dim>::n_bodies() const
{
  unsigned int n = 0;
  for (const MeshTable::Part& part : known.parts)
    n = std::max(n, part.body + 1);
  return n;
}

template <int dim>
std::uint32_t WholeMesh<dim>::fingerprint() const
{
  boost::crc_32_type sum;
  for (const dealii::Point<dim>& vertex : vertices)
    sum.process_bytes(&vertex[0], dim * sizeof(double));
  for (const auto& middle : middles)
    sum.process_bytes(&middle.second[0], dim * sizeof(double));
  for (const dealii::CellData<dim>& cell : cells) {
    sum.process_bytes(cell.vertices.data(), cell.vertices.size() * sizeof(unsigned int));
    sum.process_bytes(&cell.material_id, sizeof(cell.material_id));
  }
  const auto add_name = [&](const std::string& name) {
    sum.process_bytes(name.data(), name.size());
  };
  std::for_each(known.regions.begin(), known.regions.end(), add_name);
  for (const auto& [name, places] : known.surfaces) {
    add_name(name);
    for (const auto& place : places) {
      sum.process_bytes(&place.cell, sizeof(place.cell));
      sum.process_byte(place.vertices);
    }
  }
  return sum.checksum();
}

template <int dim>
MeshTable WholeMesh<dim>::table() const
{
  MeshTable result = known;
  result.fingerprint = fingerprint();
  const auto counted = [](const std::size_t n, const std::string& one, const std::string& several) {
    return std::to_string(n) + " " + (n == 1 ? one : several);
  };
  char shape[20];
  std::snprintf(shape, sizeof shape, "%.2g", known.worst_shape);
  result.remarks = {"mesh: " +
                    counted(cells.size(), is_quadratic() ? "quadratic cell" : "cell",
                            is_quadratic() ? "quadratic cells" : "cells") +
                    ", " + counted(known.regions.size(), "region", "regions") + ", " +
                    counted(n_bodies(), "body", "bodies") + ", shape quality of the worst cell " +
                    std::string(shape)};
  const std::vector<std::string> doubts = contacts(*this);
  result.remarks.insert(result.remarks.end(), doubts.begin(), doubts.end());
  return result;
}

template class WholeMesh<2>;
template class WholeMesh<3>;

} // namespace thelma
