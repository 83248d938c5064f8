#include <thelma/mesh/halving.h>

#include <deal.II/base/tensor.h>

#include <algorithm>

namespace thelma
{
namespace
{

using Vertex = std::array<double, 3>;

/// The middle of arcs: the mean radius in the mean direction, at the mean place along the axis.
Vertex middle(const std::vector<Vertex>& points, const std::string& around)
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
      all.push_back(middle(points, around));
    }
    return found->second;
  }

  std::vector<Vertex> all;

private:
  std::string around;
  std::map<std::vector<unsigned int>, unsigned int> known;
};

/// Of the halves of @p element, that at its corner @p half. Corners are counted by bits here, a
/// direction each; gmsh counts those of a face around it, which `order` turns into bits and back.
std::vector<unsigned int> piece(const std::vector<unsigned int>& element, const unsigned int half,
                                Vertices& vertices)
{
  constexpr std::array<unsigned int, 8> order{{0, 1, 3, 2, 4, 5, 7, 6}};
  const unsigned int n = static_cast<unsigned int>(element.size());
  std::vector<unsigned int> corners(n);
  for (unsigned int v = 0; v < n; ++v) {
    std::vector<unsigned int> parents; // as far away as v from the corner, which both keep
    for (unsigned int p = 0; p < n; ++p)
      if (((p ^ half) & ~(v ^ half)) == 0)
        parents.push_back(element[order[p]]);
    corners[order[v]] = vertices.between(parents);
  }
  return corners;
}

} // namespace

CoarseMesh halved(const CoarseMesh& mesh, const std::string& around)
{
  Vertices vertices(mesh, around);
  CoarseMesh fine{{}, mesh.groups, {}};
  for (PhysicalGroup& group : fine.groups) {
    std::vector<std::vector<unsigned int>> pieces;
    for (const auto& element : group.elements)
      for (unsigned int half = 0; half < element.size(); ++half)
        pieces.push_back(piece(element, half, vertices));
    group.elements = pieces;
  }
  fine.vertices = vertices.all;
  return fine;
}

} // namespace thelma
