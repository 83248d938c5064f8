#pragma once

#include <thelma/output/run_output.h>
#include <thelma/simulation/checkpoint.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace thelma
{

/// One scene from its parameter file to its results: heated, taken through its stages, then through
/// time.
template <int dim>
class Simulation final : public Recorder
{
public:
  /// Reads and checks @p file; results go to @p folder, progress to the @p console of rank 0.
  Simulation(MPI_Comm comm, const ParameterFile& file, std::string folder, std::ostream& console);

  /// Build mesh, fields and solver; write the mesh into @p picture_folder as mesh.vtu, if there is
  /// one. Throws InputError for whatever is wrong with the scene.
  void setup(const std::string& picture_folder = "");

  /// Whether rank 0, which asks, could write the mesh.
  bool has_drawn_mesh() const { return mesh_is_drawn; }

  /// Take up the run whose checkpoint is in the folder; setup() must have been called. Whether
  /// there is one. Throws InputError for one that does not fit; with @p if_it_fits it counts as
  /// none.
  bool resume(bool if_it_fits);

  /// Solve; setup() must have been called. What goes wrong from here on is in the Outcome.
  Outcome run();

  /// Smallest shape of a cell (Mesh::shape).
  double mesh_shape() const { return model.mesh.shape(); }

  /// What is solved for and how, a sentence to a line, after setup().
  const std::vector<std::string>& modelled() const { return outcome.modelled; }

  /// Every entry with its default or current value.
  std::string parameters() const;

  /// Whether the folder holds the results of this very scene, computed by this very program.
  bool is_finished() const;

  void record(const StepReport& step) override;
  void record_mode(const BlockVector& mode) override { output.add_mode(observable_input(), mode); }

private:
  void declare();
  void check(const std::string& picture_folder, InputErrors& found);
  ObservableInput<dim> observable_input();
  void run_phase();
  StepsEnd follow(Strategy& strategy);
  StepsEnd follow_arc();
  void end_phase(StepsEnd end, bool was_on_arc);
  void add_row(const StepReport& step, const std::string& event);

  /// Between two steps: leave a checkpoint if it is time for one. Whether the run was asked to
  /// stop.
  bool should_stop();
  Checkpoint<dim> checkpoint();

  std::string scene_folder; ///< from which the scene names its files
  bool mesh_is_drawn = false;
  unsigned int dimension = dim;
  dealii::ParameterHandler prm;
  InputErrors errors;
  Timings timings;
  RunOutput<dim> output;
  Outcome outcome;
  Model<dim> model;
  Strategies<dim> strategies;
  Phases<dim> phases;
  StepReport last_heated; ///< step of the heating
  bool resumes = false;   ///< a phase that a checkpoint has begun
};

} // namespace thelma
