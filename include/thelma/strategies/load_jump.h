#pragma once

#include <thelma/loads/loads.h>

#include <optional>
#include <vector>

namespace thelma
{

/// Loads that jump, spread over an instant between two times in s.
struct LoadJump {
  double start, end;
  std::vector<double> from, to; ///< levels

  bool is_over(const double time) const { return time >= end; }
  std::vector<double> levels(double time) const;
};

/// So much of the way between the levels of loads.
std::vector<double> levels_between(const std::vector<double>& from, std::vector<double> to,
                                   double part);

/// The jump of loads from those that are @p accepted at the time @p now, if some change within the
/// @p instant that follows.
template <int dim>
std::optional<LoadJump> jump_ahead(const Loads<dim>& loads, const std::vector<double>& accepted,
                                   double now, double instant);

} // namespace thelma
