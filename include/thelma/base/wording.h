#pragma once

#include <string>

namespace thelma
{

/// What to write in place of an @p entry that other programs or textbooks have, as `write `Shear
/// modulus``; empty if none is known.
std::string other_wording(const std::string& entry);

} // namespace thelma
