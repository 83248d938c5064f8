#pragma once

#include <thelma/application/command_line.h>
#include <thelma/output/outcome.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace thelma
{

/// A number of the report and how far it probably lies from that of an infinitely fine mesh.
struct Estimate {
  std::string name;
  double value, error;
};

/// Run the scene of @p line, then once more with every cell halved, and compare
/// (Richardson): where errors fall as h^p, that of the given mesh is the difference times
/// 1 / (1 - 2^-p). p is taken to be the polynomial degree, which smooth solutions surpass. Prints
/// the estimates and writes them to estimate.csv; returns the outcome of the given mesh.
Outcome run_with_estimate(MPI_Comm comm, const CommandLine& line, std::ostream& console);

/// Compare the ends of two runs: the fields of their pull-ins, or the values at their target.
/// Empty if they ended differently. @p factor: error per difference.
std::vector<Estimate> compare(const Outcome& given, const Outcome& finer, double factor);

} // namespace thelma
