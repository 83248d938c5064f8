#pragma once

#include <thelma/simulation/strategies.h>

namespace thelma
{

/// What a run does one after the other: the body is heated, taken through the stages, then through
/// time.
template <int dim>
class Phases
{
public:
  Phases(Model<dim>& model, Strategies<dim>& strategies) : model(model), strategies(strategies) {}

  bool remain() const { return phase < n_stages() + (model.layout.is_transient() ? 2 : 1); }
  void go_on() { ++phase; }

  bool is_heating() const { return phase == 0; }
  bool is_in_time() const { return phase > n_stages(); }

  /// Whether a stage takes the voltage to a level.
  bool drives_voltage() const { return is_stage() && index() == model.loads.index("voltage"); }

  /// The load that the stage drives, in the list of loads.
  std::size_t index() const { return stage().load; }

  /// Begin the phase with the iterate. Whether there is any way to go.
  bool begin();

  /// The strategy of the phase, led along its loads; of one that has just begun or of a
  /// checkpoint's.
  Strategy& steps();

  /// Let the path of the phase be followed along its arc from here on, until @p remainder changes
  /// sign.
  void follow_arc(const std::function<double()>& remainder);
  bool is_on_arc() const { return on_arc; }
  void leave_arc() { on_arc = false; }

  /// The phase has come to its end: its loads are at their levels.
  void finish();

  /// Load of the curve at which the phase begins.
  double first_load() const { return load_before; }

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& phase& on_arc& load_before;
  }

private:
  std::size_t n_stages() const { return model.loading.stages().list().size(); }
  bool is_stage() const { return !is_heating() && !is_in_time(); }
  const Stage& stage() const { return model.loading.stages().list()[phase - 1]; }
  bool begin_ramp();
  void change_electrode();
  LoadSymmetry symmetry() const;

  Model<dim>& model;
  Strategies<dim>& strategies;
  std::size_t phase = 0; ///< 0: heating; then the stages; then time
  bool on_arc = false;
  double load_before = 0.;
};

} // namespace thelma
