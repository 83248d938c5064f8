#pragma once

#include <thelma/materials/library.h>

#include <string>

namespace thelma
{

/// Throws InputError unless the @p value of the @p entry of a material is positive. @p where: the
/// circumstances, for the sentence.
void require_positive(const std::string& material, const std::string& entry, double value,
                      const std::string& where);

/// Throws InputError if a table of @p material does not reach a temperature of the scene.
void require_in_tables(const Material& material, const KnownTemperature& known);

/// Throws InputError unless an energy that a parameter file brings along is stable, and without
/// stress, in the body without load, which has expanded freely to @p theta (K).
void require_stable_rest(const Material& material, double theta);

} // namespace thelma
