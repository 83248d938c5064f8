#pragma once

#include <thelma/assembly/dead_loads.h>
#include <thelma/assembly/predictor.h>
#include <thelma/base/complaints.h>
#include <thelma/base/parameters.h>
#include <thelma/output/results.h>
#include <thelma/path_following.h>
#include <thelma/solvers/stepper.h>
#include <thelma/transient.h>

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>

namespace thelma
{

/// One scene from its parameter file to its results. Wires the rooms; knows no formula.
template <int dim>
class Problem
{
public:
  /// Reads and checks @p file; results go to @p folder, progress to the @p console of rank 0.
  Problem(MPI_Comm comm, const ParameterFile& file, std::string folder, std::ostream& console);

  /// Let setup() write the mesh into @p folder as mesh.vtu.
  void draw_mesh(const std::string& folder) { picture_folder = folder; }

  /// Whether rank 0, which asks, could do so.
  bool has_drawn_mesh() const { return mesh_is_drawn; }

  /// Build mesh, fields and solver. Throws InputError for whatever is wrong with the scene.
  void setup();

  /// Take up the run whose checkpoint is in the folder; setup() must have been called. Whether
  /// there is one. Throws InputError for one that does not fit; with @p if_it_fits it counts as
  /// none.
  bool resume(bool if_it_fits);

  /// Solve; setup() must have been called. What goes wrong from here on is in the Outcome.
  Outcome run();

  /// Smallest shape of a cell (Mesh::shape).
  double mesh_shape() const { return mesh.shape(); }

  /// What is solved for and how, a sentence to a line, after setup().
  const std::vector<std::string>& modelled() const { return outcome.modelled; }

  /// Every entry with its default or current value.
  std::string parameters() const;

  /// Whether the folder holds the results of this very scene, computed by this very program.
  bool finished() const;

private:
  enum class UnstableStates { automatic, reject, keep };

  /// The stage that the load factor now drives.
  struct Ramp {
    Stage::Kind kind = Stage::Kind::voltage;
    double from = 0., to = 1.; ///< levels
    double level(const double load) const { return from + load * (to - from); }

    template <class Archive>
    void serialize(Archive& archive, unsigned int)
    {
      archive& kind& from& to;
    }
  };
  using PathEnd = typename PathFollowing<dim>::End;
  using PathTask = typename PathFollowing<dim>::Task;
  using Record = std::function<void(double load, const NewtonReport&)>;

  enum class Part { heating, loads, time }; ///< of a run

  bool stops();
  void save();
  std::string misfit(const std::string& by, const std::string& scene, std::uint32_t body) const;
  template <class Archive>
  void keep(Archive& archive);
  template <class Archive>
  void keep_electrodes(Archive& archive);

  void declare();
  void find_complaints();
  void check_and_set_up(Complaints& found);
  void choose_solvers();
  std::vector<std::string> idle_entries() const;
  std::string doubt_about_thickness() const;
  void heat();
  void set_uniform_temperature(double value);
  void check_stages() const;
  bool drives_an_electrode(const Stage& stage) const;
  void check_change(const Stage& stage, const std::string& place) const;
  void apply_loads();
  void change_electrode(const Stage& stage);
  bool begin_ramp(const Stage& stage);
  void ramp(const Stage& stage);
  void show_floating_voltage();
  std::string end_in_time(const NewtonReport& last) const;
  void evolve();
  void leave_rest(const std::function<void(double)>& prescribe);
  bool follow(Stepper& steps, LoadSymmetry symmetry, const std::function<void(double)>& prescribe,
              const Record& record);
  bool hands_over(const Stepper& steps, LoadSymmetry symmetry, bool failed) const;
  NewtonReport solve() const;
  bool jumps(NewtonReport& report, const Stepper& steps);
  std::string far_gone();
  void explain_end(const Stepper& steps, const std::function<void(double)>& prescribe);
  void explain_limit(const Stepper& steps, double limit, const std::string& between);
  NewtonReport judged(System<dim>& solved, NewtonReport report) const;

  /// On from the last accepted state along the arc of the path; @p prescribe as for follow().
  PathEnd follow_arc(const PathTask& task, const std::function<void(double)>& prescribe);
  void follow_load(const std::function<void(double)>& prescribe);
  PathTask task(const Stepper& steps);
  void check_path() const;
  void explain_end(PathEnd end);
  void record(double load, const NewtonReport& report);
  void end_here(EndReason why, const std::string& details);
  Scene<dim> scene();

  std::string scene_folder;   ///< from which the scene names its files
  std::string picture_folder; ///< for mesh.vtu; empty: none
  bool mesh_is_drawn = false;
  dealii::ParameterHandler prm;
  Complaints complaints;
  Timings timings;
  Results<dim> results;

  MaterialLibrary materials;
  Mesh<dim> mesh;
  FieldLayout<dim> layout;
  BoundaryConditions<dim> conditions;
  NodalHeat<dim> nodal_heat;
  State state;
  mutable System<dim> system;
  System<dim> isothermal; ///< counts the unstable directions of states of a steady temperature
  Transient<dim> transient;
  Predictor<dim> predictor;
  Loading loading;
  DeadLoads<dim> dead_loads;
  FollowerPressure<dim> pressure;
  Newton newton;
  Stepper heating, stepper;
  PathFollowing<dim> path_following;

  unsigned int dimension = dim;
  double theta = 293., theta_start = 293.; ///< K
  Part part = Part::heating;
  std::size_t n_stages = 0; ///< that are over
  bool on_arc = false;
  bool resumes = false; ///< a step that a checkpoint has foregone
  Levels levels;        ///< reached by the stages so far
  Ramp present;
  double first_load = 0.; ///< of the present stage, in the curve
  Outcome outcome;
  Failure last_failure;
  UnstableStates unstable_states = UnstableStates::automatic;
  long long last_unstable = 0; ///< unstable directions at the newest row of the curve
};

} // namespace thelma
