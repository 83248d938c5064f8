#pragma once

#include <map>
#include <string>

namespace thelma
{

/// Give gmsh these values for the @p file that it has read, to be read again: of the names that a
/// .geo declares with DefineConstant[ a = {1, Name "a"} ]. Throws InputError for other names, and
/// for numbers of cells and the like that the file does not allow.
void set_parameters(const std::string& file, const std::map<std::string, double>& parameters);

} // namespace thelma
