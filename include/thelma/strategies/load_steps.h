#pragma once

#include <thelma/strategies/equilibrium.h>
#include <thelma/strategies/load_stepper.h>
#include <thelma/strategies/predictor.h>
#include <thelma/strategies/strategy.h>

namespace thelma
{

/// Stable states along which a load factor grows from 0 to 1.
template <int dim>
class LoadSteps final : public Strategy
{
public:
  LoadSteps(System<dim>& system, State& state, Predictor<dim>& predictor,
            const Equilibrium& equilibrium, Timings& timings)
      : system(system), state(state), predictor(predictor), equilibrium(equilibrium),
        timings(timings)
  {
  }

  void declare(dealii::ParameterHandler& prm) { stepper.declare(prm); }

  /// The way of the loads, what reversing them does, and whether a path that turns back is left to
  /// another strategy.
  void lead(LoadPath& along, const LoadSymmetry reversal, const bool turns_away)
  {
    path = &along;
    symmetry = reversal;
    gives_way = turns_away;
    has_turned = false;
  }

  /// Begin at load 0 with the iterate; give up when a failed load is within @p resolution of an
  /// accepted one.
  void start(double resolution);
  void start(double resolution, double first_step);

  /// Find the direction in which the path leaves a body at rest.
  void leave_rest();

  StepReport advance() override;
  void accept(const StepReport& step, Recorder& recorder) override;
  void cut_back(const StepReport& step) override;
  StepsEnd end() const override;
  bool can_pause() const override { return stepper.accepted() > 0.; }

  const LoadStepper& control() const { return stepper; }

  /// Why the last state that was sought has not been found.
  const Failure& last_failure() const { return failure; }

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& stepper& failure;
  }

private:
  bool jumps(NewtonReport& report);
  bool turns_soon() const;

  System<dim>& system;
  State& state;
  Predictor<dim>& predictor;
  const Equilibrium& equilibrium;
  Timings& timings;

  LoadStepper stepper;
  LoadPath* path = nullptr;
  LoadSymmetry symmetry = LoadSymmetry::none;
  bool gives_way = false, has_turned = false;
  double prediction_error = 0.; ///< of the state that was found last
  Failure failure;
};

} // namespace thelma
