#pragma once

#include <thelma/mesh/gmsh_reader.h>

#include <string>

namespace thelma
{

/// Every line, face and cell of @p mesh in halves along each direction. Its edges are arcs @p
/// around `x1`, `x2`, `x3` or `the origin`, and so are the halves: whether gmsh's own are depends
/// on its version.
CoarseMesh halved(const CoarseMesh& mesh, const std::string& around);

} // namespace thelma
