#include <thelma/output/ending.h>

#include <algorithm>
#include <array>

namespace thelma
{
namespace
{

constexpr std::array<Ending, 11> endings{{
    {EndReason::target, ExitCode::success, "target reached", "", ""},
    {EndReason::pull_in, ExitCode::success, "pull-in", "pull-in", "pull-in"},
    {EndReason::limit_point, ExitCode::not_converged, "limit point", "limit point", "limit point"},
    {EndReason::instability, ExitCode::not_converged, "instability", "bifurcation",
     "loss of stability"},
    {EndReason::no_convergence, ExitCode::not_converged, "no convergence", "no convergence",
     "no convergence"},
    {EndReason::no_load, ExitCode::not_converged, "no load", "",
     "the path has returned to zero load"},
    {EndReason::most_steps, ExitCode::not_converged, "most steps", "",
     "the path has reached the maximum number of steps"},
    {EndReason::stopped, ExitCode::stopped, "stopped", "", "stopped by a signal"},
    {EndReason::out_of_memory, ExitCode::stopped, "out of memory", "", ""},
    {EndReason::bad_input, ExitCode::bad_input, "bad input", "", ""},
    {EndReason::internal_error, ExitCode::internal_error, "internal error", "", ""},
}};

} // namespace

const Ending& ending_of(const EndReason reason)
{
  return *std::find_if(endings.begin(), endings.end(),
                       [&](const Ending& one) { return one.reason == reason; });
}

std::optional<EndReason> end_reason(const std::string& name)
{
  const auto* const found = std::find_if(endings.begin(), endings.end(),
                                         [&](const Ending& one) { return one.name == name; });
  return found == endings.end() ? std::nullopt : std::optional(found->reason);
}

} // namespace thelma
