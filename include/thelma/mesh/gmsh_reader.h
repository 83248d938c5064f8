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

/// What Thelma takes from gmsh: points in mm and named groups of linear cells, faces, lines and
/// points. Only vertices of cells are kept.
struct CoarseMesh {
  std::vector<std::array<double, 3>> vertices;
  std::vector<PhysicalGroup> groups;

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& vertices& groups;
  }
};

/// Mesh the geometry @p file (.geo with @p parameters, or .msh) in a process of its own, as some
/// geometries crash gmsh, then split every cell in halves along each direction @p refinements
/// times. Edges are arcs @p around an axis or the origin (see halved()), or straight if it is
/// empty.
/// @p dim 2 wants quadrilaterals, 3 hexahedra. Throws InputError when the file is missing, a
/// parameter is unknown, or a region has other cells or no name. To be called by one rank.
CoarseMesh read_gmsh(const std::string& file, const std::map<std::string, double>& parameters,
                     unsigned int refinements, int dim, const std::string& around);

} // namespace thelma
