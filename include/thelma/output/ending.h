#pragma once

#include <thelma/base/error.h>

#include <optional>
#include <string>

namespace thelma
{

/// Why a run ended.
enum class EndReason {
  target,
  pull_in,
  limit_point,
  instability,
  no_convergence,
  no_load,
  most_steps,
  stopped,
  out_of_memory,
  bad_input,
  internal_error
};

/// What is known of every run that ends so.
struct Ending {
  EndReason reason;
  ExitCode code;        ///< of a pull-in that was expected, success
  const char* name;     ///< `outcome` in run.json and cases.csv
  const char* event;    ///< in the last row of curve.csv
  const char* sentence; ///< begins what the run says of its end
};

const Ending& ending_of(EndReason reason);

/// The reason of this @p name; none of another name.
std::optional<EndReason> end_reason(const std::string& name);

} // namespace thelma
