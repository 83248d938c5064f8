#pragma once

#include <thelma/assembly/amplitude.h>
#include <thelma/assembly/predictor.h>
#include <thelma/assembly/system.h>
#include <thelma/solvers/time_stepper.h>

#include <functional>
#include <optional>
#include <string>

namespace thelma
{

/// The temperature in time, with the deformation or before it (theory.md, "Time").
template <int dim>
class Transient
{
public:
  using Solve = std::function<NewtonReport()>;

  Transient(const FieldLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
            NodalHeat<dim>& heat, State& state, Timings& timings)
      : layout(layout), conditions(conditions), heat(heat), state(state),
        system(layout, conditions, heat, state, timings)
  {
  }

  void declare(dealii::ParameterHandler& prm);

  /// Throws InputError for an amplitude that cannot be read, that nothing follows, or that is not
  /// finite all the time.
  void read_amplitudes();

  /// Throws InputError if a wall, or what surrounds one, comes below 1 K on its way from the
  /// temperature @p theta (K) of time 0.
  void check_walls(double theta) const;

  /// Choose the solver as for @p deformation, which counts unstable directions.
  void choose(System<dim>& deformation);

  /// @p deformation solves for displacement and potential at given temperatures. @p voltage (kV)
  /// and the wall temperatures are multiplied by their amplitudes, @p theta in K is uniform at
  /// time 0.
  void setup(const System<dim>& deformation, double voltage, double theta);

  /// Begin at time 0 with the iterate.
  void start();

  bool finished() const { return stepper.finished(); }
  bool exhausted() const { return stepper.exhausted(); }

  /// Try the next step; @p solve_deformation finds a stable state at given temperatures.
  NewtonReport step(Predictor<dim>& predictor, const Newton& newton,
                    const Solve& solve_deformation);

  /// Accept the step, unless its error is too large or, as that of the very first try, unknown;
  /// then the last state is back.
  bool accept();

  /// Return to the last accepted state and shorten the step.
  void cut_back();

  bool is_monolithic() const { return coupling == Coupling::monolithic; }
  bool makes_heat() const { return structural_heat != StructuralHeat::none; }
  System<dim>& heated_system() { return system; }
  double initial_voltage() const { return voltage_at(0.); }
  double step_size() const { return stepper.step(); }
  double final_time() const { return stepper.final_time(); }

  /// How time is treated, and which coupling is cheaper, and why.
  std::vector<std::string> summary() const;

  /// How far it has come.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& stepper& wall_parts;
  }

private:
  enum class Coupling { staggered, monolithic };

  /// The fields at a time in s.
  struct Moment {
    double time;
    const BlockVector* x;
  };

  std::vector<double> samples() const;
  double warming() const;
  bool wall_jumps() const;
  void prescribe(double time, double part);
  NewtonReport deform(Predictor<dim>& predictor, const Solve& solve_deformation,
                      const NewtonReport& warmed, bool extrapolates);
  void restore();
  double voltage_at(double time) const { return voltage * (*voltage_amplitude)(time); }
  std::vector<double> times() const;
  double distance(const Moment& moment, const std::vector<Moment>& others) const;
  std::optional<StepError> find_error() const;

  const FieldLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  NodalHeat<dim>& heat;
  State& state;
  System<dim> system; ///< of the temperature, or of everything
  TimeStepper stepper;

  std::optional<State::Accepted> longer; ///< where a first step led that was too long
  std::optional<StepError> step_error;   ///< of the step that was tried last

  /// Walls that jump do so in this many parts, as a shorter time makes no jump smaller.
  unsigned int wall_parts = 1;

  Coupling coupling = Coupling::staggered;
  StructuralHeat structural_heat = StructuralHeat::none;
  std::string voltage_text = "1", wall_text = "1", power_text = "1";
  std::optional<Amplitude> voltage_amplitude, wall_amplitude, power_amplitude;
  std::vector<double> kinks, bends; ///< of all amplitudes, s
  double voltage = 0., theta = 0.;  ///< kV, K
};

} // namespace thelma
