#pragma once

#include <thelma/assembly/system.h>
#include <thelma/strategies/predictor.h>
#include <thelma/strategies/strategy.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// A state found on a path.
struct PathState : StepReport {
  double slope = 0.; ///< of the load over arc length, in the direction of travel
  double arc = 0.;   ///< length from the first of the remembered states, of a located state

  /// What a step that begins here needs to know.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& load& slope& unstable_directions;
  }
};

/// Finds single states of a path, beyond the accepted ones and between them (theory.md, "Path
/// following").
template <int dim>
class PathSolver
{
public:
  using Solution = std::optional<PathState>;

  PathSolver(System<dim>& system, State& state, Predictor<dim>& predictor, const Newton& newton,
             NewtonEffort& spent)
      : system(system), state(state), predictor(predictor), newton(newton), spent(spent)
  {
  }

  /// Measure the path by this displacement alone, which the @p row picks.
  void control(PathMetric::Displacement row) { metric.choose(std::move(row)); }

  /// Measure it by its arc length, scaled by what the load has done so far.
  void choose_metric();
  double length(const PathMetric::Displacement& u, const double load) const
  {
    return metric.length(u, load);
  }

  /// Arc lengths of the accepted states.
  std::vector<double> arc_lengths() const;

  /// The plane through the iterate across the direction from the accepted state @p from to it; the
  /// plane of a load.
  Plane across(const State::Accepted& from) const;
  Plane across_load(double load) const;

  /// Go a @p step on from the last accepted state, from a lone one along its tangent. Whether there
  /// is a guess.
  bool predict(double step);

  /// The state in the @p plane, which faces forward.
  Solution solve(const Plane& plane);

  /// Tangent, slope and count of unstable directions at the iterate; @p plane faces forward.
  /// Whether the tangent could be factorised.
  bool refine_and_count(const Plane& plane, PathState& found);

  /// The state at the arc length @p arc between the last two accepted states.
  Solution between(double arc);

  /// The state at the @p load between them.
  Solution at_load(double load);

  /// Where @p value, of a state at arc lengths @p low to @p high of the last step, changes sign.
  Solution locate(double low, double high, double tolerance,
                  const std::function<double(const PathState&)>& value);

  /// Make the accepted state @p at the iterate of the system.
  void go_to(const State::Accepted& at);

  /// Start anew with the state that the accepted ones have at the arc length @p arc.
  void start_at(double arc);

  /// Why the last state that was sought has not been found.
  const std::string& last_failure() const { return failure; }
  void fail(const std::string& reason) { failure = reason; }

  /// Of smallest size, of the tangent at the iterate; System::critical_mode().
  double critical_mode(BlockVector& mode) { return system.critical_mode(mode); }

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& metric;
  }

private:
  System<dim>& system;
  State& state;
  Predictor<dim>& predictor;
  const Newton& newton;
  NewtonEffort& spent;
  PathMetric metric;
  std::string failure;
};

} // namespace thelma
