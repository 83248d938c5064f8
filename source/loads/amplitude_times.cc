// Where an amplitude bends, so that time steps do not step over what it does.

#include <thelma/base/error.h>
#include <thelma/loads/amplitude.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>

namespace thelma
{
namespace
{

struct Sample {
  double time, value;
};

double slope(const Sample& a, const Sample& b)
{
  return (b.value - a.value) / (b.time - a.time);
}

/// Evenly spread, and between the numbers that the expression itself has, as those of a short
/// pulse.
std::vector<double> sample_times(const std::string& expression, const double end)
{
  constexpr unsigned int n = 100000;
  std::vector<double> times, named;
  for (unsigned int k = 0; k <= n; ++k)
    times.push_back(end * k / n);
  static const std::regex number("(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?");
  for (std::sregex_iterator at(expression.begin(), expression.end(), number), none; at != none;
       ++at)
    if (const double time = std::strtod(at->str().c_str(), nullptr); time < end)
      named.push_back(time);
  std::sort(named.begin(), named.end());
  for (std::size_t k = 1; k < named.size(); ++k)
    times.push_back((named[k - 1] + named[k]) / 2.);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// The last time before the amplitude jumps between @p a and @p b by more than @p least, if it
/// does.
std::optional<double> jump(const Amplitude& amplitude, Sample a, Sample b, const double least)
{
  if (std::abs(b.value - a.value) <= least)
    return {};
  for (double middle = 0.; middle = (a.time + b.time) / 2., a.time < middle && middle < b.time;) {
    const Sample half{middle, amplitude(middle)};
    (std::abs(half.value - a.value) > std::abs(b.value - half.value) ? b : a) = half;
  }
  return std::abs(b.value - a.value) > least / 2. ? std::optional<double>(a.time) : std::nullopt;
}

/// Where the lines before and after sample @p i meet, if they have other slopes there than a smooth
/// curve has.
std::optional<double> kink(const std::vector<Sample>& samples, const std::size_t i,
                           const double range)
{
  constexpr double distinct = 10., noise = 1e-8;
  const auto turn = [&](const std::size_t k) {
    return slope(samples[k], samples[k + 1]) - slope(samples[k - 1], samples[k]);
  };
  const double here = std::abs(turn(i)),
               smooth = std::max(std::abs(turn(i - 2)), std::abs(turn(i + 2))),
               width = samples[i + 1].time - samples[i - 1].time;
  if (here <= distinct * smooth || here * width <= noise * range)
    return {};
  const Sample &a = samples[i - 1], &b = samples[i + 1];
  const double before = slope(samples[i - 2], a), after = slope(b, samples[i + 2]);
  const double time = (b.value - after * b.time - a.value + before * a.time) / (before - after);
  return a.time < time && time < b.time ? std::optional<double>(time) : std::nullopt;
}

/// The ends of straight lines that pass all samples within @p tolerance, begun anew at @p kinks.
std::vector<double> straight_lines(const std::vector<Sample>& samples,
                                   const std::vector<double>& kinks, const double tolerance)
{
  std::vector<double> ends;
  double least = -INFINITY, most = INFINITY;
  std::size_t start = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto next = std::upper_bound(kinks.begin(), kinks.end(), samples[start].time);
    const bool passes_kink = next != kinks.end() && *next < samples[i].time;
    const double now = slope(samples[start], samples[i]);
    if (passes_kink || now < least || now > most) {
      if (!passes_kink)
        ends.push_back(samples[i - 1].time);
      start = passes_kink ? i : i - 1;
      least = -INFINITY;
      most = INFINITY;
    }
    if (i > start) {
      const double way = samples[i].time - samples[start].time;
      least = std::max(least, slope(samples[start], samples[i]) - tolerance / way);
      most = std::min(most, slope(samples[start], samples[i]) + tolerance / way);
    }
  }
  return ends;
}

} // namespace

AmplitudeTimes Amplitude::times(const double end) const
{
  if (formula)
    return times_of_formula(end);
  AmplitudeTimes found;
  for (const auto& row : rows)
    found.kinks.push_back(row.first);
  return found;
}

AmplitudeTimes Amplitude::times_of_formula(const double end) const
{
  constexpr double negligible = 0.02; // of all that it changes
  static const std::regex time("\\bt\\b");
  AmplitudeTimes found;
  std::vector<Sample> samples;
  const bool is_constant = !std::regex_search(text, time);
  for (const double at : is_constant ? std::vector<double>{0.} : sample_times(text, end)) {
    samples.push_back({at, (*this)(at)});
    if (!std::isfinite(samples.back().value))
      throw InputError(place + ": it is " + as_text(samples.back().value) +
                       " at t = " + as_text(at) + " s; write what is a number from 0 to Time/End");
  }
  const auto [low, high] =
      std::minmax_element(samples.begin(), samples.end(),
                          [](const Sample& a, const Sample& b) { return a.value < b.value; });
  const double range = high->value - low->value;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (const auto at = jump(*this, samples[i - 1], samples[i], negligible * range))
      found.kinks.push_back(*at);
    else if (i > 2 && i + 3 < samples.size())
      if (const auto corner = kink(samples, i, range))
        found.kinks.push_back(*corner);
  std::sort(found.kinks.begin(), found.kinks.end());
  found.bends = straight_lines(samples, found.kinks, negligible * range);
  return found;
}

} // namespace thelma
