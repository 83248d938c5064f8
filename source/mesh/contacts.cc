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

/// Parts of two bodies whose outer faces meet.
template <int dim>
std::set<Pair> touching_parts(const WholeMesh<dim>& mesh, const double tolerance)
{
  using Face = std::pair<dealii::BoundingBox<dim>, unsigned int>;
  std::map<std::vector<unsigned int>, std::pair<unsigned int, std::vector<dealii::Point<dim>>>>
      once;
  for (const dealii::CellData<dim>& cell : mesh.cells)
    for (unsigned int f = 0; f < dealii::GeometryInfo<dim>::faces_per_cell; ++f) {
      std::vector<unsigned int> corners;
      std::vector<dealii::Point<dim>> points;
      for (unsigned int v = 0; v < cell.vertices.size(); ++v)
        if (face_vertices<dim>(f) & (1u << v)) {
          corners.push_back(cell.vertices[v]);
          points.push_back(mesh.vertices[cell.vertices[v]]);
        }
      std::sort(corners.begin(), corners.end());
      const auto [place, is_new] = once.emplace(corners, std::pair(cell.material_id, points));
      if (!is_new)
        once.erase(place);
    }
  std::vector<Face> faces;
  for (const auto& [corners, face] : once) {
    faces.emplace_back(dealii::BoundingBox<dim>(face.second), face.first);
    faces.back().first.extend(tolerance);
  }
  const auto tree = dealii::pack_rtree(faces);
  std::set<Pair> found;
  for (const Face& face : faces) {
    std::vector<Face> near;
    tree.query(boost::geometry::index::intersects(face.first), std::back_inserter(near));
    for (const Face& other : near)
      if (mesh.body_of_part(other.second) != mesh.body_of_part(face.second))
        found.insert(pair_of(face.second, other.second));
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
  const std::string remedy = ", so that nothing passes from one to the other; weld them in the "
                             "geometry (Coherence, BooleanFragments, Coherence Mesh)";
  for (const auto& [parts, n] : coincident)
    sentences.push_back("warning: " + std::to_string(n) + " nodes of " + names(parts) +
                        " lie upon each other but are not the same" + remedy);
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
