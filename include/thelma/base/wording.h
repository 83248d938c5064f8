#pragma once

#include <string>

namespace thelma
{

/// What to write in place of an @p entry that other programs or textbooks have, as `write `Shear
/// modulus``; empty if none is known.
std::string other_wording(const std::string& entry);

/// A name of the mesh as parameter files write it, with a semicolon for every comma or colon, which
/// are separators there.
std::string writable(std::string name);

/// A @p value of a parameter file without its quotation marks, and what is between them writable().
std::string unquoted(const std::string& value);

} // namespace thelma
