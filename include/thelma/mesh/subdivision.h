#pragma once

#include <thelma/mesh/gmsh_reader.h>

#include <string>

namespace thelma
{

/// Every line, polygon and solid of @p mesh cut from its middle: lines, quadrilaterals and
/// hexahedra in halves along each direction, triangles in three quadrilaterals, tetrahedra and
/// prisms in four and six hexahedra. Edges are straight or, unless it is empty, arcs @p around
/// `x1`, `x2`, `x3` or `the origin`; whether gmsh's own pieces are depends on its version.
CoarseMesh subdivided(const CoarseMesh& mesh, const std::string& around);

} // namespace thelma
