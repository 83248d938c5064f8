#pragma once

#include <thelma/assembly/predictor.h>
#include <thelma/assembly/system.h>

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace thelma
{

/// What a path passes.
struct PathEvent {
  enum class Kind { none, limit_point, bifurcation };
  Kind kind = Kind::none;
  long long multiplicity = 1; ///< of a bifurcation

  /// As in the curve.
  std::string name() const;
};

/// A state found on a path.
struct PathState {
  NewtonReport report;
  double load = 0.;
  double slope = 0.; ///< of the load over arc length, in the direction of travel
  double step = 0.;  ///< of arc length, the next one
  double place = 0.; ///< arc length from the first of the remembered states, of a located event
  long long unstable_directions = 0;
  PathEvent event;

  /// What a step that begins here needs to know.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& load& slope& unstable_directions;
  }
};

/// Follows equilibria along their arc length, through limit points and bifurcations, which it
/// locates (theory.md, "Path following").
template <int dim>
class PathFollowing
{
public:
  PathFollowing(System<dim>& system, State& state, Predictor<dim>& predictor, const Newton& newton)
      : system(system), state(state), predictor(predictor), newton(newton)
  {
  }

  void declare(dealii::ParameterHandler& prm);

  /// Find the controlled displacement, if there is one. Throws InputError.
  void setup(const Mesh<dim>& mesh, const FieldLayout<dim>& layout,
             const BoundaryConditions<dim>& conditions);

  bool is_automatic() const { return continuation == Continuation::automatic; }
  bool chooses_branch() const { return branch != Branch::none; }

  /// Whether a limit point announces itself on a path whose loads grow in steps of @p step.
  bool turns_soon(double step) const
  {
    return state.estimated_limit() < state.accepted_load() + 3. * step;
  }

  enum class End { target, observable, limit_point, no_load, most_steps, lost, stopped };

  /// What follow() is to do.
  struct Task {
    double first_step, largest_step;   ///< of the load
    bool stop_at_limit;                ///< whether the first limit point is the aim
    std::function<double()> remainder; ///< changes sign where the path is to end; may be empty
    std::function<void(const PathState&)> record;
    std::function<void(const BlockVector&)> record_mode; ///< of a bifurcation
    std::function<bool()> stops; ///< asked between two steps, when all that matters is data
  };

  /// From the last accepted state until load 1 or another end; or on, if that @p resumes what a
  /// checkpoint knows.
  End follow(const Task& task, bool resumes);

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& stepper& metric& here& n_steps& on_branch& spent& n_failures;
  }

  const NewtonEffort& effort() const { return spent; }
  unsigned int failures() const { return n_failures; }

  /// Why the last state that was sought has not been found.
  const std::string& last_failure() const { return failure; }

private:
  enum class Continuation { load, automatic };
  enum class Branch { none, plus, minus };
  using Solution = std::optional<PathState>;

  void choose_metric();
  double distance(const BlockVector& a, double load_a, const BlockVector& b, double load_b) const;
  std::vector<double> places() const;

  /// The plane through the iterate across the direction from the accepted state @p from to it.
  Plane across(const State::Accepted& from) const;
  Plane across_load(double load) const;
  bool predict(double step);
  Solution solve(const Plane& plane);
  Solution advance();
  void turn_back(double length);

  /// Tangent, slope and count of unstable directions at the iterate; @p plane faces forward.
  /// Whether the tangent could be factorised.
  bool examine(const Plane& plane, PathState& found);

  /// The state at @p place between the last two accepted states.
  Solution between(double place);

  /// Where @p value, of a state at arc lengths @p low to @p high of the last step, changes sign.
  Solution locate(double low, double high, double tolerance,
                  const std::function<double(const PathState&)>& value);
  Solution locate_limit(double low, double high);
  Solution locate_bifurcation(double low, double high, long long before);
  Solution land_on_target();
  struct Place {
    double arc, slope;
    long long unstable_directions;
  };
  struct Event {
    PathState found;
    State::Accepted at;
    BlockVector mode; ///< of a bifurcation
  };
  enum class Events { none, aim, new_branch, hidden };
  bool find_events(const Place& low, const Place& high, std::vector<Event>& events);
  Events report(const Task& task, const Event& event);
  Events report_events(const Task& task, const PathState& next);
  void start_branch(double place);
  Solution switch_branch(double step);
  bool begin(const Task& task);
  void resume();
  std::optional<End> finish(const Task& task, const PathState& next);

  System<dim>& system;
  State& state;
  Predictor<dim>& predictor;
  const Newton& newton;

  Continuation continuation = Continuation::load;
  Branch branch = Branch::none;
  std::map<std::string, std::string> controlled;
  unsigned int most_steps = 1000;

  ArcStepper stepper;
  double largest_step = 1., remainder = 0.;
  PathMetric metric;
  PathState here; ///< at the last accepted state
  unsigned int n_steps = 0;
  bool on_branch = false;
  BlockVector mode;
  NewtonEffort spent;
  unsigned int n_failures = 0;
  std::string failure;
};

} // namespace thelma
