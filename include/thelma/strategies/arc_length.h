#pragma once

#include <thelma/strategies/arc_stepper.h>
#include <thelma/strategies/equilibrium.h>
#include <thelma/strategies/path_events.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// Follows equilibria along their arc length, through limit points and bifurcations, which it
/// locates (theory.md, "Path following").
template <int dim>
class ArcLength final : public Strategy
{
public:
  ArcLength(System<dim>& system, State& state, Predictor<dim>& predictor,
            const Equilibrium& equilibrium)
      : system(system), state(state), predictor(predictor), newton(equilibrium.solver()),
        path(system, state, predictor, newton, spent.newton)
  {
  }

  void declare(dealii::ParameterHandler& prm);

  /// Find the controlled displacement, if there is one. Throws InputError.
  void setup(const Mesh<dim>& mesh, const DofLayout<dim>& layout,
             const BoundaryConditions<dim>& conditions);

  bool is_automatic() const { return continuation == Continuation::automatic; }
  bool chooses_branch() const { return branch != Branch::none; }

  /// Where it is to lead.
  struct Aim {
    double first_step, largest_step;   ///< of the load
    bool stop_at_limit;                ///< whether the first limit point is the aim
    std::function<double()> remainder; ///< changes sign where the path is to end; may be empty
  };

  /// The way of the loads, whose load 1 is an end.
  void lead(LoadPath& along, const Aim& where);

  /// Begin at the last accepted state; or there go on with what a checkpoint knows.
  void start();
  void resume();

  StepReport advance() override;
  void accept(const StepReport& step, Recorder& recorder) override;
  void cut_back(const StepReport& step) override;
  StepsEnd end() const override;
  bool can_pause() const override { return n_steps > 0; } // there is a second state to go on from

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& stepper& path& here& n_steps& on_branch;
  }

  /// Why the last state that was sought has not been found.
  const std::string& last_failure() const { return path.last_failure(); }

private:
  enum class Continuation { load, automatic };
  enum class Branch { none, plus, minus };

  bool pass_events(Recorder& recorder);
  std::optional<PathState> switch_branch(const BlockVector& mode, double step);
  std::optional<StepsEnd> finish(Recorder& recorder);

  System<dim>& system;
  State& state;
  Predictor<dim>& predictor;
  const Newton& newton;
  PathSolver<dim> path;

  Continuation continuation = Continuation::load;
  Branch branch = Branch::none;
  std::map<std::string, std::string> controlled;
  unsigned int most_steps = 1000;

  Aim aim{};
  ArcStepper stepper;
  PathState here, next;             ///< at the last accepted state, at the one that was found
  std::optional<double> remainder;  ///< at the last accepted state, once that is known
  std::vector<LocatedEvent> events; ///< on the way to the next one
  bool is_hiding = false;           ///< whether the next one hides one
  unsigned int n_steps = 0;
  bool on_branch = false;
  StepsEnd ended = StepsEnd::none;
};

} // namespace thelma
