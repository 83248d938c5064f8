#pragma once

#include <thelma/mesh/gmsh_reader.h>

#include <map>
#include <string>
#include <vector>

namespace thelma
{

/// The named groups of the mesh that gmsh has read as @p request says, up to those of dimension
/// @p dim, which are the regions, and the middles of its quadratic cells, for the nodes of @p mesh,
/// which @p index numbers. Throws InputError for a name that two groups have, a group without name,
/// a region without cells, cells without a region, and elements other than linear or quadratic ones
/// of hexahedra, quadrilaterals, lines and points, and those that can be subdivided.
void read_physical_groups(const GmshRequest& request, int dim,
                          const std::map<std::size_t, unsigned int>& index, CoarseMesh& mesh);

} // namespace thelma
