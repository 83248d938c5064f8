#include <thelma/mesh/subdivision.h>

#include <deal.II/base/tensor.h>

#include <algorithm>

namespace thelma
{
namespace
{

using Vertex = std::array<double, 3>;

Vertex mean(const std::vector<Vertex>& points)
{
  const double n = static_cast<double>(points.size());
  Vertex result{};
  for (const Vertex& point : points)
    for (int d = 0; d < 3; ++d)
      result[d] += point[d] / n;
  return result;
}

/// The middle of arcs: the mean radius in the mean direction, at the mean place along the axis.
Vertex arc_middle(const std::vector<Vertex>& points, const std::string& around)
{
  dealii::Tensor<1, 3> direction, along;
  double radius = 0.;
  for (const Vertex& point : points) {
    dealii::Tensor<1, 3> r;
    for (int d = 0; d < 3; ++d)
      (around == "x" + std::to_string(d + 1) ? along : r)[d] += point[d];
    radius += r.norm();
    if (r.norm() > 0.)
      direction += r / r.norm();
  }
  if (direction.norm() > 0.)
    direction /= direction.norm();
  const dealii::Tensor<1, 3> sum = radius * direction + along;
  const double n = static_cast<double>(points.size());
  return {{sum[0] / n, sum[1] / n, sum[2] / n}};
}

/// The vertices of a mesh and those between them, each made once.
class Vertices
{
public:
  Vertices(const CoarseMesh& mesh, const std::string& around) : all(mesh.vertices), around(around)
  {
  }

  /// The vertex in the middle of @p corners, or the only one.
  unsigned int between(std::vector<unsigned int> corners)
  {
    if (corners.size() == 1)
      return corners.front();
    std::sort(corners.begin(), corners.end());
    const auto [found, is_new] = known.emplace(corners, all.size());
    if (is_new) {
      std::vector<Vertex> points;
      for (const unsigned int corner : corners)
        points.push_back(all[corner]);
      all.push_back(around.empty() ? mean(points) : arc_middle(points, around));
    }
    return found->second;
  }

  std::vector<Vertex> all;

private:
  std::string around;
  std::map<std::vector<unsigned int>, unsigned int> known;
};

using Faces = std::vector<std::vector<unsigned int>>;

/// The faces of a tetrahedron, prism or hexahedron, each by its corners around it.
const Faces& faces_of_solid(const std::size_t n_corners)
{
  static const std::map<std::size_t, Faces> known{
      {4, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}},
      {6, {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {0, 2, 5, 3}, {1, 2, 5, 4}}},
      {8, {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}}};
  return known.at(n_corners);
}

/// The hexahedron at a @p corner of a solid, where three faces meet.
std::vector<unsigned int> hexahedron(const std::vector<unsigned int>& solid,
                                     const unsigned int corner, Vertices& vertices)
{
  std::vector<unsigned int> ends; // of the edges from the corner
  const auto numbers = [&](const std::vector<unsigned int>& corners) {
    std::vector<unsigned int> result;
    for (const unsigned int c : corners)
      result.push_back(solid[c]);
    return result;
  };
  std::vector<Faces::value_type> faces;
  for (const auto& face : faces_of_solid(solid.size()))
    for (std::size_t i = 0; i < face.size(); ++i)
      if (face[i] == corner) {
        faces.push_back(face);
        for (const std::size_t next : {i + 1, i + face.size() - 1})
          if (const unsigned int end = face[next % face.size()];
              std::find(ends.begin(), ends.end(), end) == ends.end())
            ends.push_back(end);
      }
  const auto on_edge = [&](const int end) {
    return vertices.between(numbers({corner, ends[end]}));
  };
  const auto on_face = [&](const int a, const int b) {
    const auto has_both = [&](const std::vector<unsigned int>& face) {
      return std::count(face.begin(), face.end(), ends[a]) +
                 std::count(face.begin(), face.end(), ends[b]) ==
             2;
    };
    return vertices.between(numbers(*std::find_if(faces.begin(), faces.end(), has_both)));
  };
  return {solid[corner], on_edge(0),    on_face(0, 1),           on_edge(1),
          on_edge(2),    on_face(0, 2), vertices.between(solid), on_face(1, 2)};
}

/// Points stay; lines, polygons and solids are cut from their middle, and those of their edges and
/// faces.
std::vector<std::vector<unsigned int>> pieces(const std::vector<unsigned int>& element,
                                              const int dimension, Vertices& vertices)
{
  const std::size_t n = element.size();
  std::vector<std::vector<unsigned int>> result;
  for (std::size_t v = 0; v < n; ++v) {
    const unsigned int corner = element[v], next = element[(v + 1) % n],
                       last = element[(v + n - 1) % n];
    if (dimension == 0)
      result.push_back(element);
    else if (dimension == 1)
      result.push_back({corner, vertices.between(element)});
    else if (dimension == 2)
      result.push_back({corner, vertices.between({corner, next}), vertices.between(element),
                        vertices.between({last, corner})});
    else
      result.push_back(hexahedron(element, static_cast<unsigned int>(v), vertices));
  }
  return result;
}

} // namespace

CoarseMesh subdivided(const CoarseMesh& mesh, const std::string& around)
{
  Vertices vertices(mesh, around);
  CoarseMesh fine{{}, mesh.groups, {}};
  for (PhysicalGroup& group : fine.groups) {
    std::vector<std::vector<unsigned int>> elements;
    for (const auto& element : group.elements)
      for (const auto& piece : pieces(element, group.dimension, vertices))
        elements.push_back(piece);
    group.elements = elements;
  }
  fine.vertices = vertices.all;
  return fine;
}

} // namespace thelma
