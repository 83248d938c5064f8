#pragma once

#include <thelma/fields/rates.h>

#include <string>
#include <vector>

namespace thelma
{

/// How rates follow from the iterate and the accepted states. A new scheme is one file and one line
/// in time_schemes.cc; the error of a step follows from its weights.
struct TimeScheme {
  std::string name, meaning;
  unsigned int order; ///< 1 or 2, once so many states have been accepted

  /// The rates at the @p time, given the @p times of the accepted states, newest last: one at
  /// least, of which the newest two may have weights. They are exact for what changes evenly.
  Rates (*rates)(double time, const std::vector<double>& times);
};

/// The schemes a .prm can choose; the first is the default.
const std::vector<TimeScheme>& time_schemes();

/// The one of this @p name, which is in the list.
const TimeScheme& time_scheme(const std::string& name);

/// Error of a step by a @p scheme as a part of the distance between its result and the polynomial
/// of the @p order through the accepted states, given their @p times, newest last (theory.md,
/// eq. 39). Where fewer states are known than the scheme has orders, that of a lower order.
double error_share(const TimeScheme& scheme, double time, const std::vector<double>& times,
                   unsigned int order);

} // namespace thelma
