#pragma once

#include <thelma/strategies/time_schemes.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// What a time step did wrong.
struct StepError {
  double value;       ///< in its own unit, or over the tolerance
  unsigned int order; ///< of the differences that made it
};

/// Chooses times between 0 and the end so that the error of each step stays below a tolerance.
class TimeStepper
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Whether there is a temperature, and internal variables, whose errors have tolerances.
  void control(bool has_temperature, bool has_memory);

  /// An @p error, if it is known, over its tolerance; zero where nothing is asked.
  using MaybeError = std::optional<StepError>;
  MaybeError of_temperature(const MaybeError& error) const { return over(tolerance, error); }
  MaybeError of_memory(const MaybeError& error) const { return over(strain_tolerance, error); }

  /// Begin at time 0; the steps meet each of the times @p kinks, those that the scene names and,
  /// where their length is not given, the times @p bends.
  void start(const std::vector<double>& kinks, const std::vector<double>& bends);

  /// A warning about @p bends that steps pass over; empty if there are none.
  std::string steps_over(std::vector<double> bends) const;

  const TimeScheme& scheme() const { return *chosen; }

  /// Next time to try, in s; within an instant in which loads jump, which lasts @p until a time.
  double next();
  double next_in_jump(double until);

  /// Whether the @p error of the step over the tolerance is small enough; an unknown one is not.
  bool tolerates(const MaybeError& error) const
  {
    return !is_adaptive || (error && error->value <= 1.);
  }

  /// End the step and choose the length of the next. Returns whether its @p error is tolerated; if
  /// not, the step is cut and to be taken again.
  bool accept(const MaybeError& error);

  /// After a step that failed.
  void cut_back();

  bool finished() const { return time >= end; }

  /// Whether no shorter step is worth a try: without a state one as short as no time, or as a part
  /// of a jump that nobody sees; with an error as long as the time has digits.
  bool exhausted() const
  {
    const double moment = std::min(instant(), 1e-3 * initial);
    const double digits = 1e-12 * time;
    return size < (!has_failed  ? std::max(1e-15 * end, digits)
                   : is_in_jump ? 1e-5 * instant()
                                : std::max(moment, digits));
  }
  double step() const { return size; }
  double final_time() const { return end; }

  /// So short a time in s that nothing flows.
  double instant() const { return 1e-9 * end; }

  /// How far it has come.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& time& trial& size& stops;
  }

private:
  static MaybeError over(const double tolerance, MaybeError error)
  {
    if (error)
      error->value = tolerance > 0. ? error->value / tolerance : 0.;
    return error;
  }

  double end = 1., initial = 0.01, largest = 1e300, tolerance = 0.1, strain_tolerance = 1e-3;
  bool is_adaptive = true;
  const TimeScheme* chosen = &time_schemes().front();
  std::vector<double> wanted_stops;

  double time = 0., trial = 0., size = 0.;
  bool has_failed = false; ///< to find a state at the time that was tried last
  bool is_in_jump = false; ///< that time
  std::vector<double> stops;
};

/// Error of the first step, to @p time from 0, as a part of the distance between the result of a
/// @p longer first step and the line through the start and the result of this one (theory.md,
/// eq. 40).
double first_error_share(double time, double longer);

} // namespace thelma
