#pragma once

#include <thelma/mesh/gmsh_reader.h>

namespace thelma
{

/// What gmsh tells of a type of elements.
struct ElementProperties {
  explicit ElementProperties(int type);

  std::string shape; ///< "Point", "Line", "Triangle", "Quadrilateral", "Tetrahedron", ...
  int dimension = 0, order = 0, n_nodes = 0, n_corners = 0;
  std::vector<double> at; ///< the coordinates of the nodes in the element, one after the other
};

/// The highest order of the elements that gmsh has, 0 if there are none.
int element_order();

/// Let gmsh mesh the geometry that it has read, or halve the elements that a .msh brings along, as
/// the request says; those to be subdivided are left as they are. It cuts linear elements only, and
/// only a geometry tells where their quadratic nodes come to lie: throws InputError for cuts of
/// others, and for more cells than there is memory.
void make_elements(const GmshRequest& request, int dim);

} // namespace thelma
