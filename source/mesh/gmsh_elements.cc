#include <thelma/base/error.h>
#include <thelma/base/memory.h>
#include <thelma/mesh/gmsh_elements.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace thelma
{
namespace
{

/// Refining makes cells faster than anyone thinks. Elements that are not @p cut yet give a cell at
/// each corner.
void require_memory(const unsigned int refinements, const int dim, const bool cut)
{
  // To read 2.1 million hexahedra took 2.8 GB; the rest of the run takes at least as much.
  constexpr double bytes_per_cell = 2. * 1350.;
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, dim);
  double n_coarse = 0.;
  for (const int type : types) {
    std::vector<std::size_t> elements, nodes;
    gmsh::model::mesh::getElementsByType(type, elements, nodes);
    n_coarse +=
        static_cast<double>(elements.size() * (cut ? 1 : ElementProperties(type).n_corners));
  }
  const double n_cells = n_coarse * std::pow(2., dim * static_cast<double>(refinements));
  if (n_cells * bytes_per_cell > machine_memory())
    throw InputError("section Mesh, entry 'Refinements': halving " + as_text(n_coarse) + " cells " +
                     std::to_string(refinements) + " times gives " + as_text(n_cells) +
                     ", too many for the memory of this machine (" +
                     as_text(std::round(machine_memory() / 1e9)) + " GB); refine less");
}

} // namespace

ElementProperties::ElementProperties(const int type)
{
  std::string name;
  gmsh::model::mesh::getElementProperties(type, name, dimension, order, n_nodes, at, n_corners);
  shape = name.substr(0, name.find(' '));
}

int element_order()
{
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types);
  int highest = 0;
  for (const int type : types)
    highest = std::max({highest, ElementProperties(type).order, 1});
  return highest;
}

void make_elements(const GmshRequest& request, const int dim)
{
  const int given = element_order();
  const unsigned int cuts = request.around.empty() ? request.refinements : 0;
  if (given > 1 && (cuts > 0 || request.is_subdivided))
    throw InputError("section Mesh, entry '" + std::string(cuts > 0 ? "Refinements" : "Cells") +
                     "': the elements of '" + request.file + "' are of order " +
                     std::to_string(given) +
                     ", which only its geometry can cut; cut them in gmsh, or give the .geo");
  if (given > 0 && request.is_subdivided) {
    require_memory(request.refinements, dim, false);
    return;
  }
  if (request.is_subdivided) {
    gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", dim - 1);
    gmsh::option::setNumber("Mesh.RecombineAll", dim == 2);
  }
  if (given == 0)
    gmsh::model::mesh::generate(dim);
  const int order = element_order();
  require_memory(request.refinements, dim, true);
  for (unsigned int i = 0; i < cuts; ++i)
    gmsh::model::mesh::refine();
  if (cuts > 0 && order > 1)
    gmsh::model::mesh::setOrder(order);
}

} // namespace thelma
