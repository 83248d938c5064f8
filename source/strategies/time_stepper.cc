#include <thelma/base/error.h>
#include <thelma/base/option_names.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/strategies/time_stepper.h>

#include <algorithm>
#include <cmath>

namespace thelma
{

void TimeStepper::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Time"});
  add_quantity(prm, "End", end, "Where a transient run ends.", Quantity("s", 1e-12));
  std::vector<std::pair<std::string, const TimeScheme*>> schemes;
  std::string meanings;
  for (const TimeScheme& scheme : time_schemes()) {
    schemes.emplace_back(scheme.name, &scheme);
    meanings += (meanings.empty() ? "`" : "; `") + scheme.name + "`: " + scheme.meaning;
  }
  OptionNames<const TimeScheme*>(schemes).declare(prm, "Scheme", chosen, meanings + ".");
  add_quantity(prm, "Initial step", initial,
               "First time step to try. Half of it is compared with it, and so on until the "
               "error is within the tolerance.",
               Quantity("s", 1e-15));
  add_quantity(prm, "Largest step", largest, "Largest time step.", Quantity("s", 1e-15));
  add_quantity(prm, "Tolerance", tolerance,
               "Error of the temperature that one time step may make (root mean square over the "
               "nodes); 0: the temperature does not choose the steps. Without any tolerance every "
               "step is as long as the first.",
               Quantity("K", 0.).of_difference());
  prm.add_parameter("Strain tolerance", strain_tolerance,
                    "Error of the internal variables of laws that remember, such as the viscous "
                    "strain C_v, that one time step may make (root mean square over the points); "
                    "0: they do not choose the steps.",
                    dealii::Patterns::Double(0.));
  add_quantity(prm, "Stops", wanted_stops,
               "Times that the steps meet, beside the corners and jumps of amplitudes and, unless "
               "the steps are all alike, the times between which these are straight within 2 %.",
               Quantity("s", 0.), 0, 1000000);
}

void TimeStepper::control(const bool has_temperature, const bool has_memory)
{
  is_adaptive =
      (has_memory && strain_tolerance > 0.) || ((has_temperature || !has_memory) && tolerance > 0.);
}

void TimeStepper::start(const std::vector<double>& kinks, const std::vector<double>& bends)
{
  time = trial = 0.;
  size = std::min(initial, largest);
  stops = kinks;
  stops.insert(stops.end(), wanted_stops.begin(), wanted_stops.end());
  if (is_adaptive)
    stops.insert(stops.end(), bends.begin(), bends.end());
  std::sort(stops.begin(), stops.end());
  const auto is_near = [&](const double a, const double b) { return b - a < instant(); };
  stops.erase(std::unique(stops.begin(), stops.end(), is_near), stops.end());
  stops.erase(std::lower_bound(stops.begin(), stops.end(), end - instant()), stops.end());
  stops.push_back(end);
}

std::string TimeStepper::steps_over(std::vector<double> bends) const
{
  constexpr std::size_t most = 20000;
  if (bends.size() > most)
    return "warning: the amplitudes change so often up to Time/End that time steps may pass over "
           "some of it; shorten Time/End, or give them as tables";
  if (is_adaptive || bends.empty())
    return "";
  bends.push_back(0.);
  std::sort(bends.begin(), bends.end());
  double shortest = end;
  for (std::size_t k = 1; k < bends.size(); ++k)
    shortest = std::min(shortest, bends[k] - bends[k - 1]);
  const double step = std::min(initial, largest);
  if (step <= 2. * shortest)
    return "";
  return "warning: time steps of " + as_text(step) +
         " s pass over amplitudes that are not straight " + "for longer than " + as_text(shortest) +
         " s; choose a shorter Time/Initial step, or a Time/Tolerance above 0";
}

double TimeStepper::next()
{
  is_in_jump = false;
  const double stop = *std::upper_bound(stops.begin(), stops.end(), time);
  const double left = stop - time, n_steps = std::ceil(left / size * (1. - 1e-9));
  trial = n_steps <= 1. ? stop : time + (n_steps <= 2. ? left / 2. : size);
  return trial;
}

double TimeStepper::next_in_jump(const double until)
{
  trial = std::min(next(), until);
  is_in_jump = true;
  return trial;
}

bool TimeStepper::accept(const MaybeError& error)
{
  constexpr double safety = 0.9, least = 0.2, most = 2., unknown = 0.5;
  double factor = is_adaptive ? unknown : most; // after a cut, back to the first length
  if (is_adaptive && error)
    factor =
        std::clamp(safety * std::pow(1. / std::max(error->value, 1e-300), 1. / (error->order + 1)),
                   least, most);
  const bool accepted = tolerates(error);
  has_failed = false;
  const double taken = trial - time;
  if (accepted)
    time = trial;
  // A step that only met a stop says nothing against longer ones.
  const double longest = is_adaptive ? largest : std::min(initial, largest);
  size = accepted ? std::min(std::max(factor * taken, factor >= 1. ? size : 0.), longest)
                  : std::min(factor, 0.8) * taken;
  return accepted;
}

void TimeStepper::cut_back()
{
  size = (trial - time) / 4.;
  has_failed = true;
}

double first_error_share(const double time, const double longer)
{
  return time * time / (2. * longer * (longer - time));
}

} // namespace thelma
