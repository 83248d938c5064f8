#include <thelma/application/convergence.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace thelma
{
namespace
{

/// Columns that neither a finer mesh nor shorter steps make more exact.
bool is_bookkeeping(const std::string& column)
{
  static const std::vector<std::string> names{"step",
                                              "load",
                                              "time_s",
                                              "e",
                                              "voltage_kV",
                                              "theta_K",
                                              "unstable_directions",
                                              "newton_iterations",
                                              "linear_iterations",
                                              "seconds"};
  return std::find(names.begin(), names.end(), column) != names.end();
}

/// The end of a column's name: mm of tip_u1_mm, mJ_per_K of ledger_entropy_mJ_per_K.
std::string unit(const std::string& column)
{
  std::size_t last = column.rfind('_');
  if (last != std::string::npos && last > 4 && column.compare(last - 4, 4, "_per") == 0)
    last = column.rfind('_', last - 5);
  return last == std::string::npos ? column : column.substr(last + 1);
}

/// Largest number of each unit. One that is many times smaller is zero but for round-off.
std::map<std::string, double> scales(const Outcome& outcome)
{
  std::map<std::string, double> largest;
  for (const auto& [name, value] : outcome.final_values)
    if (!is_bookkeeping(name))
      largest[unit(name)] = std::max(largest[unit(name)], std::abs(value));
  return largest;
}

const double* find(const Outcome& outcome, const std::string& column)
{
  for (const auto& [name, value] : outcome.final_values)
    if (name == column)
      return &value;
  return nullptr;
}

bool ended_at_pull_in(const Outcome& outcome)
{
  return outcome.pull_in && outcome.ended != EndReason::target;
}

} // namespace

Convergence convergence(const std::vector<double>& values, const std::size_t given,
                        const double highest_order, const double noise)
{
  // Roache's factors of safety are 1.25 and, without a measured order, 3, which covers orders of
  // 0.6 on.
  constexpr double share = 0.25, lowest_order = 0.5;
  const double finest = values.back(), last = finest - values[values.size() - 2],
               before = values[1] - values[0];
  if (values.size() == 2)
    return {2. * last, std::abs(last)};
  // What keeps all its digits has converged, what keeps none is zero but for round-off.
  constexpr double all = 1e-3, none = 0.5;
  const double larger = std::max(std::abs(before), std::abs(last));
  if (larger <= noise &&
      (larger < all * std::abs(finest) || larger > none * std::abs(finest) || larger == 0.))
    return {0., 3. * larger};
  const double order = std::log2(std::abs(before / last)); // infinite if the last two agree
  const double left = last / (std::exp2(std::clamp(order, lowest_order, highest_order)) - 1.);
  const double way = finest - values[given];
  if (before * last < 0.)
    return {way, share * std::abs(way) + (1. + share) * std::abs(left)};
  return {way + left, share * std::abs(way + left), !(before * last > 0. && order < lowest_order)};
}

std::vector<Result> results(const Outcome& outcome, const double newton_tolerance)
{
  constexpr double softness = 10.; // of a body, by which a residual displaces it
  std::vector<Result> found;
  if (outcome.pull_in) {
    const double below = outcome.pull_in->e_below, above = outcome.pull_in->e_above;
    found.push_back({"pull_in_e", (below + above) / 2., (above - below) / 2.});
  }
  if (ended_at_pull_in(outcome))
    return found;
  std::map<std::string, double> scale = scales(outcome);
  for (const auto& [name, value] : outcome.final_values)
    if (!is_bookkeeping(name))
      found.push_back({name, value, softness * newton_tolerance * scale[unit(name)]});
  return found;
}

std::string disagreement(const Outcome& given, const Outcome& other)
{
  if (other.code == ExitCode::not_converged || given.ended != other.ended ||
      given.pull_in.has_value() != other.pull_in.has_value())
    return "ended differently: " + (other.reason.empty() ? other.name() : other.reason);
  if (ended_at_pull_in(given))
    return "";
  // Of a mirror image what is large has changed its sign, and has about its size.
  constexpr double large = 1e-2;
  std::map<std::string, double> scale = scales(given);
  for (const auto& [name, value] : given.final_values)
    if (const double* there = find(other, name);
        there && !is_bookkeeping(name) && std::abs(value) > large * scale[unit(name)] &&
        std::abs(value + *there) < 0.5 * std::abs(value - *there))
      return "followed the opposite branch: " + name + " is " + as_text(*there) + " there, " +
             as_text(value) + " here";
  return "";
}

std::string doubt(const Outcome& given, const Outcome& other)
{
  constexpr char column[] = "unstable_directions";
  const double *here = find(given, column), *there = find(other, column);
  if (!here || !there || *here == *there)
    return "";
  return "ended in a state with " + as_text(*there) + " unstable direction(s) instead of " +
         as_text(*here) + ", possibly on another branch";
}

} // namespace thelma
