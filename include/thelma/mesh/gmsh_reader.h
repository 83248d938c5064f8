#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace thelma
{

/// A named physical group: its elements by their vertices, in gmsh's order.
struct PhysicalGroup {
  std::string name;
  int dimension;
  std::vector<std::vector<unsigned int>> elements;

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& name& dimension& elements;
  }
};

/// Nodes of quadratic elements in the middle of edges, faces and cells, by the sorted vertices of
/// these.
template <typename Point>
using Middles = std::map<std::vector<unsigned int>, Point>;

/// What Thelma takes from gmsh: points in mm and named groups of cells, faces, lines and points by
/// their vertices. Only vertices of cells are kept.
struct CoarseMesh {
  std::vector<std::array<double, 3>> vertices;
  std::vector<PhysicalGroup> groups;
  Middles<std::array<double, 3>> middles; ///< of quadratic cells

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& vertices& groups& middles;
  }
};

/// What the file of a mesh is and what to make of it.
struct GmshRequest {
  std::string file; ///< .geo or .msh
  std::map<std::string, double> parameters;
  double unit = 1.;             ///< of its lengths, in mm
  bool is_subdivided = false;   ///< cut triangles into quadrilaterals, tetrahedra into hexahedra
  unsigned int refinements = 0; ///< how often to halve every cell along each direction
  std::string around;           ///< an axis or the origin if edges are arcs, see subdivided()
};

/// Mesh the geometry in a process of its own, as some geometries crash gmsh. @p dim 2 wants
/// quadrilaterals, 3 hexahedra. Throws InputError when the file is missing, a parameter is unknown,
/// or a region has other cells or no name. To be called by one rank.
CoarseMesh read_gmsh(const GmshRequest& request, int dim);

} // namespace thelma
