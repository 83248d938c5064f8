#pragma once

#include <thelma/simulation/model.h>
#include <thelma/strategies/arc_length.h>
#include <thelma/strategies/load_steps.h>
#include <thelma/strategies/time_steps.h>

namespace thelma
{

/// Heats the body from the stress-free state: there, free expansion is a better guess than none.
template <int dim>
class HeatingPath final : public LoadPath
{
public:
  HeatingPath(Model<dim>& model, Ramp<dim>& ramp) : model(model), ramp(ramp) {}

  void go_to(const double load) override
  {
    if (model.state.path().size() == 1)
      model.system.cells.initialise_internal();
    ramp.go_to(load);
  }

private:
  Model<dim>& model;
  Ramp<dim>& ramp;
};

/// The ways through the states of a model. A new one is a member here, and a phase of the
/// simulation that chooses it.
template <int dim>
struct Strategies {
  explicit Strategies(Model<dim>& model);

  void declare(dealii::ParameterHandler& prm);

  /// Set up what may find fault with the scene, collected in @p found; layout and conditions must
  /// stand, the mesh is there.
  void check(bool has_conditions, InputErrors& found);

  /// Choose the linear solvers for what is asked of them. Throws InputError.
  void choose_solvers();

  bool follow_path() const { return arc_length.is_automatic(); }

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& heating& load_steps& arc_length& time_steps& ramp;
  }

  Model<dim>& model;
  Equilibrium equilibrium;
  LoadSteps<dim> heating, load_steps;
  ArcLength<dim> arc_length;
  TimeSteps<dim> time_steps;
  Ramp<dim> ramp;
  HeatingPath<dim> heating_path;
};

} // namespace thelma
