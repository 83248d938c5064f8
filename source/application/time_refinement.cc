#include <thelma/application/time_refinement.h>
#include <thelma/base/error.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace thelma
{

std::vector<double> step_times(const MPI_Comm comm, const std::string& folder)
{
  std::vector<double> times;
  on_rank_0(comm, [&]() {
    std::ifstream curve(folder + "/curve.csv");
    std::string line;
    std::getline(curve, line);
    const std::vector<std::string> names = dealii::Utilities::split_string_list(line);
    const auto column = std::find(names.begin(), names.end(), "time_s") - names.begin();
    while (std::getline(curve, line)) {
      const double time = std::stod(dealii::Utilities::split_string_list(line).at(column));
      if (time > (times.empty() ? 0. : times.back()))
        times.push_back(time);
    }
  });
  return dealii::Utilities::MPI::broadcast(comm, times);
}

std::vector<Override> steps_in_parts(const std::vector<double>& times, const unsigned int parts)
{
  std::ostringstream stops;
  stops << std::setprecision(17);
  double from = 0.;
  for (const double to : times) {
    for (unsigned int part = 1; part <= parts; ++part)
      stops << (from == 0. && part == 1 ? "" : ", ")
            << (part == parts ? to : from + (to - from) * part / parts);
    from = to;
  }
  std::ostringstream longest;
  longest << std::setprecision(17) << times.back();
  return {{{"Time"}, "Stops", stops.str()},
          {{"Time"}, "Tolerance", "0"},
          {{"Time"}, "Initial step", longest.str()},
          {{"Time"}, "Largest step", longest.str()}};
}

} // namespace thelma
