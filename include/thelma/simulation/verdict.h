#pragma once

#include <thelma/output/run_output.h>
#include <thelma/simulation/strategies.h>

#include <string>

namespace thelma
{

/// Says why a phase of a run has ended before its aim, in the outcome and at the newest row of the
/// curve.
template <int dim>
class Verdict
{
public:
  Verdict(Model<dim>& model, Strategies<dim>& strategies, RunOutput<dim>& output, Outcome& outcome,
          const ObservableInput<dim>& scene)
      : model(model), strategies(strategies), output(output), outcome(outcome), scene(scene)
  {
  }

  /// No stable state while the body was heated.
  void on_heating();

  /// The load steps of the load @p index in the list found none beyond a load.
  void on_load_steps(std::size_t index);

  /// A path that was followed came to this @p end.
  void on_path(StepsEnd end);

  void on_time();

private:
  void end_here(EndReason why, const std::string& details);
  void on_limit(std::size_t index, double limit, const std::string& between);
  void on_bifurcation(const std::string& between, BlockVector& mode);
  std::string between_times(double failed) const;
  std::string far_gone() const;

  Model<dim>& model;
  Strategies<dim>& strategies;
  RunOutput<dim>& output;
  Outcome& outcome;
  const ObservableInput<dim>& scene;
};

} // namespace thelma
