#pragma once

#include <thelma/mesh/gmsh_reader.h>

namespace thelma
{

/// Let gmsh mesh the geometry that it has read, or cut the elements that a .msh brings along, as
/// the request says. It cuts linear elements only, and only a geometry tells where their quadratic
/// nodes come to lie: throws InputError for cuts of others, and for more cells than there is
/// memory.
void make_elements(const GmshRequest& request, int dim);

} // namespace thelma
