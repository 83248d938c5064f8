#pragma once

#include <thelma/strategies/equilibrium.h>
#include <thelma/strategies/load_jump.h>
#include <thelma/strategies/predictor.h>
#include <thelma/strategies/strategy.h>
#include <thelma/strategies/time_error.h>
#include <thelma/strategies/time_stepper.h>

#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// States in time, under loads that follow their amplitudes: the temperature, if it is a field that
/// changes in time, with the deformation or before it (theory.md, "Time").
template <int dim>
class TimeSteps final : public Strategy
{
public:
  TimeSteps(DiscreteSystem<dim>& deformation, DiscreteSystem<dim>& heated,
            const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
            Loads<dim>& loads, State& state, Predictor<dim>& predictor,
            const Equilibrium& equilibrium)
      : deformation(deformation), heated(heated), layout(layout), conditions(conditions),
        loads(loads), state(state), predictor(predictor), equilibrium(equilibrium)
  {
  }

  void declare(dealii::ParameterHandler& prm);

  /// Throws InputError for settings of time in a scene that has none.
  void check() const;

  /// Choose the solver of the temperature, or of everything, as for the deformation, which counts
  /// unstable directions.
  void choose();

  /// Whether laws remember, so that their errors choose the steps too.
  void control(const bool remembers)
  {
    has_memory = remembers;
    stepper.control(has_heat(), has_memory);
  }

  /// The step that was refused last, whose load is its time.
  const StepReport& last_failure() const { return failed; }

  /// The jump of the loads that is under way.
  const std::optional<LoadJump>& jump() const { return jumping; }

  /// Begin at time 0 with the iterate.
  void start();

  StepReport advance() override;
  void accept(const StepReport& step, Recorder& recorder) override;
  void cut_back(const StepReport& step) override;
  StepsEnd end() const override;

  /// No checkpoint holds what the search for the first step has found so far, or half a jump.
  bool can_pause() const override
  {
    return state.path().size() > 1 && (!jumping || jumping->is_over(state.accepted_load()));
  }

  /// Why no step is short enough, and what helps.
  std::string why_exhausted() const;

  /// The system that tells of the reactions of a state in time.
  DiscreteSystem<dim>& system() { return is_monolithic() ? heated : deformation; }
  bool makes_heat_by_power() const { return structural_heat == StructuralHeat::power; }
  double final_time() const { return stepper.final_time(); }

  /// How time is treated, and which coupling is cheaper, and why.
  std::vector<std::string> summary() const;

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& stepper& parts& accepted_levels;
  }

private:
  enum class Coupling { staggered, monolithic };

  bool has_heat() const { return layout.has_transient_temperature(); }
  bool is_monolithic() const { return has_heat() && coupling == Coupling::monolithic; }
  NewtonReport solve(bool is_last_part, bool extrapolates);
  void include(const TimeStepper::MaybeError& relative);
  NewtonReport deform(bool extrapolates);
  void prescribe(double time, unsigned int part);

  DiscreteSystem<dim>&deformation, &heated;
  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  Loads<dim>& loads;
  State& state;
  Predictor<dim>& predictor;
  const Equilibrium& equilibrium;

  TimeStepper stepper;
  Coupling coupling = Coupling::staggered;
  StructuralHeat structural_heat = StructuralHeat::none;

  std::optional<State::Accepted> longer; ///< where a first step led that was too long
  std::optional<StepError> step_error;   ///< of the step that was tried last
  std::vector<double> accepted_levels;   ///< of the loads in the last accepted state
  std::optional<LoadJump> jumping;
  unsigned int parts = 1; ///< in which loads that jump come, as time does not help
  bool has_memory = false, is_exhausted = false;
  StepReport failed; ///< the step that was refused last
};

} // namespace thelma
