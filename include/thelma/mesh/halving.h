#pragma once

#include <thelma/mesh/gmsh_reader.h>

#include <string>

namespace thelma
{

/// Every line, face and cell of @p mesh in halves along each direction. Its edges are arcs @p
/// around `x1`, `x2`, `x3` or `the origin`, and so are the halves: whether gmsh's own are depends
/// on its version.
CoarseMesh halved(const CoarseMesh& mesh, const std::string& around);

/// Every triangle in three quadrilaterals, every tetrahedron or prism in four or six hexahedra, and
/// lines and what meets them so as to fit; new nodes are in the middle, as a mesh without geometry
/// has no better place for them.
CoarseMesh subdivided(const CoarseMesh& mesh);

} // namespace thelma
