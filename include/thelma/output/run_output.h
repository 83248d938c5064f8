#pragma once

#include <thelma/base/parameters.h>
#include <thelma/base/timings.h>
#include <thelma/output/checkpoints.h>
#include <thelma/output/fields.h>
#include <thelma/output/observables/chosen_observables.h>
#include <thelma/output/outcome.h>
#include <thelma/solvers/newton.h>

#include <deal.II/base/conditional_ostream.h>

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// Where an accepted step stands on the path.
struct PathPoint {
  double load, e;
  double step_size;              ///< of the next step
  double part;                   ///< of the whole path, if that is known
  long long unstable_directions; ///< of a symmetric system
  std::string event;
};

/// What a run leaves: lines on the console and, in its folder, the curve, the fields, used.prm and
/// run.json.
template <int dim>
class RunOutput
{
public:
  /// Takes the names of the observables from @p file, so that they can declare their entries.
  RunOutput(MPI_Comm comm, const ParameterFile& file, std::string folder, std::ostream& console,
            Timings& timings);

  void declare(dealii::ParameterHandler& prm);

  /// Expectations are those at @p theta in K.
  void setup(const ObservableInput<dim>& scene, double theta);

  /// Whether a run with these @p parameters has already finished in the folder, and none of the
  /// files @p inputs has changed since.
  bool is_finished(const std::string& parameters, const std::vector<std::string>& inputs) const;

  /// Create the folder with used.prm, a copy of @p parameters, and print what is @p outcome
  /// .modelled. Of a run that is @p continued only what the checkpoint does not know goes.
  void start(const std::string& parameters, const Outcome& outcome, double theta, bool continued);

  /// Whether so long a time has passed since the last checkpoint that it is worth another.
  bool checkpoint_is_due() const { return since_checkpoint.seconds() >= checkpoint_interval; }
  void write_checkpoint(const std::string& content);

  /// The newest checkpoint on all ranks; none unless it is younger than the files @p inputs.
  std::optional<std::string> read_checkpoint(const std::vector<std::string>& inputs);

  /// What the observables say of their columns in this scene.
  std::vector<std::string> remarks() const { return observed.remarks(); }

  /// How to go on after the run was stopped.
  std::string advice() const { return "continue with thelma --restart " + folder; }

  /// What has been left so far.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    double spent = seconds();
    archive& spent& timings& fields&* curve& observed;
    seconds_before = spent - stopwatch.seconds();
  }

  void add(const ObservableInput<dim>& scene, const PathPoint& point, const NewtonReport& report);

  /// Throws InputError, with @p place in the sentence, if no observable has @p column.
  void require_column(const std::string& column, const std::string& place) const
  {
    observed.require_column(column, place);
  }

  /// What @p column of an observable is in the present state.
  double value(const ObservableInput<dim>& scene, const std::string& column)
  {
    return observed.value(scene, column);
  }

  /// Write an eigenvector of the tangent as `mode_0.pvtu`, ...
  void add_mode(const ObservableInput<dim>& scene, const BlockVector& mode)
  {
    fields.write_mode(scene, folder, mode);
  }

  /// Mark the newest step.
  void set_event(const std::string& event) { curve->set_event(event); }

  /// Check the expectations, complete @p outcome and write everything.
  void finish(const ObservableInput<dim>& scene, Outcome& outcome);

private:
  /// Where the fields of the state stand in the .pvd: time or load.
  static double abscissa(const ObservableInput<dim>& scene, double load);

  double seconds() const { return seconds_before + stopwatch.seconds(); }
  void print_step(const ObservableInput<dim>& scene, const PathPoint& point,
                  const NewtonReport& report);

  MPI_Comm comm;
  std::string file_name, folder;
  dealii::ConditionalOStream console;
  Timings& timings;
  Stopwatch stopwatch, since_checkpoint;
  double seconds_before = 0.; ///< of the run that is continued
  double checkpoint_interval = 60.;
  Checkpoints checkpoints;
  ChosenObservables<dim> observed;
  FieldWriter<dim> fields;
  Expectations expectations;
  std::unique_ptr<Curve> curve;
};

} // namespace thelma
