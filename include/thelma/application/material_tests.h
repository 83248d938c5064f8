#pragma once

#include <thelma/application/command_line.h>

#include <iosfwd>

namespace thelma
{

/// `thelma --material-point FILE.prm`: the stresses of homogeneous tests of the materials in a
/// scene, for programs that fit or plot them (doc/fitting.md). Each line of @p in is a request in
/// JSON and gets a line of @p out as its answer, until there is none left; the answer to one that
/// cannot be met is an `error`. Throws InputError if the scene's materials cannot be read.
void answer_material_tests(const CommandLine& line, std::istream& in, std::ostream& out);

} // namespace thelma
