// Bodies that lie together in space but not in the mesh, as where a geometry has not been welded.

#include <thelma/mesh/whole_mesh.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

namespace thelma
{
namespace
{

using Pair = std::pair<unsigned int, unsigned int>; ///< of parts, the smaller number first

Pair pair_of(const unsigned int a, const unsigned int b)
{
  return {std::min(a, b), std::max(a, b)};
}

template <int dim>
std::vector<unsigned int> parts_of_vertices(const WholeMesh<dim>& mesh)
{
  std::vector<unsigned int> part(mesh.vertices.size());
  for (const dealii::CellData<dim>& cell : mesh.cells)
    for (const unsigned int v : cell.vertices)
      part[v] = cell.material_id;
  return part;
}

/// The numbers of the boxes of this @p width, of a grid, that @p vertex lies in or next to.
template <int dim>
std::set<std::size_t> boxes_near(const dealii::Point<dim>& vertex, const double width,
                                 const double tolerance)
{
  std::set<std::size_t> boxes;
  for (unsigned int corner = 0; corner < 1u << dim; ++corner) {
    std::size_t number = 0;
    for (unsigned int d = 0; d < dim; ++d) {
      const double x = vertex[d] + (corner & (1u << d) ? tolerance : -tolerance);
      number = 1000003 * number + static_cast<std::size_t>(std::llround(x / width));
    }
    boxes.insert(number);
  }
  return boxes;
}

/// How many nodes of each two parts lie upon each other.
template <int dim>
std::map<Pair, unsigned int> coincident_nodes(const WholeMesh<dim>& mesh,
                                              const std::vector<unsigned int>& part,
                                              const double tolerance)
{
  std::unordered_map<std::size_t, std::vector<unsigned int>> of_box;
  std::map<Pair, unsigned int> found;
  std::set<Pair> known; // pairs of nodes
  for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
    for (const std::size_t box : boxes_near(mesh.vertices[v], 1e3 * tolerance, tolerance)) {
      for (const unsigned int w : of_box[box])
        if (mesh.vertices[v].distance(mesh.vertices[w]) < tolerance &&
            known.insert(pair_of(v, w)).second)
          ++found[pair_of(part[v], part[w])];
      of_box[box].push_back(v);
    }
  return found;
}

/// A face of one cell alone.
template <int dim>
struct OuterFace {
  unsigned int part;
  std::vector<dealii::Point<dim>> corners; ///< in lexicographic order
};

template <int dim>
std::vector<OuterFace<dim>> outer_faces(const WholeMesh<dim>& mesh)
{
  std::map<std::vector<unsigned int>, OuterFace<dim>> once;
  for (const dealii::CellData<dim>& cell : mesh.cells)
    for (unsigned int f = 0; f < dealii::GeometryInfo<dim>::faces_per_cell; ++f) {
      std::vector<unsigned int> corners;
      OuterFace<dim> face{cell.material_id, {}};
      for (unsigned int v = 0; v < cell.vertices.size(); ++v)
        if (face_vertices<dim>(f) & (1u << v)) {
          corners.push_back(cell.vertices[v]);
          face.corners.push_back(mesh.vertices[cell.vertices[v]]);
        }
      std::sort(corners.begin(), corners.end());
      const auto [place, is_new] = once.emplace(corners, face);
      if (!is_new)
        once.erase(place);
    }
  std::vector<OuterFace<dim>> faces;
  for (const auto& [corners, face] : once)
    faces.push_back(face);
  return faces;
}

/// Whether @p x is nearer than the @p tolerance to the line between two points or to the triangle
/// of three; its coordinates in it solve the normal equations.
template <int dim>
bool lies_on(const std::vector<dealii::Point<dim>>& simplex, const dealii::Point<dim>& x,
             const double tolerance)
{
  dealii::Tensor<1, dim> edges[2];
  for (unsigned int i = 1; i < dim; ++i)
    edges[i - 1] = simplex[i] - simplex[0];
  const dealii::Tensor<1, dim> way = x - simplex[0];
  const double a = edges[0] * edges[0], b = edges[0] * edges[1],
               c = dim == 3 ? edges[1] * edges[1] : 1., determinant = a * c - b * b;
  const double f = way * edges[0], g = way * edges[1];
  const double s = (c * f - b * g) / determinant, t = (a * g - b * f) / determinant;
  const double slack = tolerance / std::sqrt(std::max(a, c));
  return s > -slack && t > -slack && s + t < 1. + slack &&
         (way - s * edges[0] - t * edges[1]).norm() < tolerance;
}

/// Whether a corner, the middle of an edge or of all of one lies on the other.
template <int dim>
bool reaches(const OuterFace<dim>& one, const OuterFace<dim>& other, const double tolerance)
{
  std::vector<std::vector<dealii::Point<dim>>> simplices{
      {other.corners.begin(), other.corners.begin() + dim}};
  if (dim == 3)
    simplices.push_back({other.corners.rbegin(), other.corners.rbegin() + dim});
  for (const dealii::Point<dim>& from : one.corners)
    for (const dealii::Point<dim>& to : one.corners)
      for (const auto& simplex : simplices)
        if (lies_on(simplex, from + (to - from) / 2., tolerance))
          return true;
  return false;
}

/// Parts of two bodies whose outer faces meet.
template <int dim>
std::set<Pair> touching_parts(const WholeMesh<dim>& mesh, const double tolerance)
{
  using Boxed = std::pair<dealii::BoundingBox<dim>, std::size_t>;
  const std::vector<OuterFace<dim>> faces = outer_faces(mesh);
  std::vector<Boxed> boxes;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    boxes.emplace_back(dealii::BoundingBox<dim>(faces[i].corners), i);
    boxes.back().first.extend(tolerance);
  }
  const auto tree = dealii::pack_rtree(boxes);
  std::set<Pair> found;
  for (const Boxed& box : boxes) {
    std::vector<Boxed> near;
    tree.query(boost::geometry::index::intersects(box.first), std::back_inserter(near));
    const OuterFace<dim>& face = faces[box.second];
    for (const Boxed& neighbour : near)
      if (const OuterFace<dim>& other = faces[neighbour.second];
          mesh.body_of_part(other.part) != mesh.body_of_part(face.part) &&
          reaches(face, other, tolerance))
        found.insert(pair_of(face.part, other.part));
  }
  return found;
}

} // namespace

template <int dim>
std::vector<std::string> contacts(const WholeMesh<dim>& mesh)
{
  double extent = 0.;
  for (const dealii::Point<dim>& vertex : mesh.vertices)
    extent = std::max(extent, vertex.distance(mesh.vertices.front()));
  const double tolerance = 1e-7 * extent;
  const std::map<Pair, unsigned int> coincident =
      coincident_nodes(mesh, parts_of_vertices(mesh), tolerance);
  std::vector<std::string> sentences;
  const auto names = [&](const Pair& parts) {
    return "'" + mesh.region_of_part(parts.first) + "' and '" + mesh.region_of_part(parts.second) +
           "'";
  };
  const std::string remedy = ", so the two are not connected; merge them in the geometry "
                             "(Coherence, BooleanFragments, Coherence Mesh)";
  for (const auto& [parts, n] : coincident)
    sentences.push_back("warning: " + std::to_string(n) + " nodes of " + names(parts) +
                        " coincide but are not shared" + remedy);
  if (mesh.n_bodies() > 1)
    for (const Pair& parts : touching_parts(mesh, tolerance))
      if (coincident.count(parts) == 0)
        sentences.push_back("warning: faces of " + names(parts) + " meet without common nodes" +
                            remedy);
  return sentences;
}

template std::vector<std::string> contacts(const WholeMesh<2>&);
template std::vector<std::string> contacts(const WholeMesh<3>&);

} // namespace thelma
