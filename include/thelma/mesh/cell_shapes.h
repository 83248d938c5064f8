#pragma once

#include <thelma/mesh/gmsh_reader.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <cstdint>
#include <vector>

namespace thelma
{

/// The vertices of face @p f of a cell, as bits.
template <int dim>
std::uint8_t face_vertices(unsigned int f);

/// The vertices of @p cell in @p mask, sorted.
template <int dim>
std::vector<unsigned int> sorted_vertices(const dealii::CellData<dim>& cell, std::uint8_t mask);

/// Turn the cells whose volume is negative. deal.II's own function for this throws, since 9.5, at a
/// cell that no turn mends.
template <int dim>
void turn_negative(const std::vector<dealii::Point<dim>>& vertices,
                   std::vector<dealii::CellData<dim>>& cells);

/// All nodes of a quadratic @p cell, in the order of a Lagrange element of degree 2. Those that
/// have no middle lie where a serendipity element puts them.
template <int dim>
std::vector<dealii::Point<dim>> quadratic_nodes(const dealii::CellData<dim>& cell,
                                                const std::vector<dealii::Point<dim>>& vertices,
                                                const Middles<dealii::Point<dim>>& middles);

/// The smallest Jacobian at a corner over the product of the edges there: where it is 1 a cell is a
/// box, where 0 it is flat.
template <int dim>
double shape_of_corners(const std::vector<dealii::Point<dim>>& corners);

/// The same at all nodes of a quadratic cell, with the tangents of the coordinate lines for edges.
template <int dim>
double shape_of_nodes(const std::vector<dealii::Point<dim>>& nodes);

} // namespace thelma
