#pragma once

#include <thelma/materials/material.h>

namespace thelma
{

/// How stiff the volume must be at the points of a cell whose pressure sees only means of it, so
/// that a strong field does not tilt the cell into a wedge (theory.md, eqs. 28 to 30): MPa, at most
/// @p most, and zero where the field is too weak to matter. @p pressure is that of the cell. With
/// @p dim = 2 nothing moves along axis 2, and no wave goes there.
double needed_stabilisation(const Material& material, const PointState<>& state, double pressure,
                            int dim, double most);

} // namespace thelma
