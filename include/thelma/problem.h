#pragma once

#include <thelma/assembly/predictor.h>
#include <thelma/base/parameters.h>
#include <thelma/output/fields.h>
#include <thelma/output/outcome.h>
#include <thelma/solvers/stepper.h>

#include <deal.II/base/conditional_ostream.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// One scene from its parameter file to its results. Wires the rooms; knows no formula.
template <int dim>
class Problem
{
public:
  /// Reads and checks @p file; results go to @p folder.
  Problem(const ParameterFile& file, std::string folder);

  /// Build mesh, fields and solver. Throws InputError for whatever is wrong with the scene.
  void setup();

  /// Solve; setup() must have been called. What goes wrong from here on is in the Outcome.
  Outcome run();

  /// Every entry with its default or current value.
  void print_parameters(std::ostream& stream) const;

private:
  using Record = std::function<void(double load, const NewtonReport&)>;

  void declare();
  void create_folder() const;
  void heat();
  void apply_voltage();
  bool follow(Stepper& steps, LoadSymmetry symmetry, const std::function<void(double)>& prescribe,
              const Record& record);
  NewtonReport solve() const;
  long long unstable_directions(const NewtonReport& report) const;
  void explain_end(const Stepper& steps);
  void record(double load, const NewtonReport& report);
  void finish();
  Outcome failure(const std::string& name, const std::string& reason) const;
  void print_step(double load, const NewtonReport& report);
  Scene<dim> scene() const;

  std::string file_name, folder;
  dealii::ParameterHandler prm;
  dealii::ConditionalOStream console;
  Timings timings;

  MaterialLibrary materials;
  Mesh<dim> mesh;
  FieldLayout<dim> layout;
  BoundaryConditions<dim> conditions;
  State state;
  mutable System<dim> system;
  Predictor<dim> predictor;
  Loading loading;
  Newton newton;
  Stepper stepper;
  Expectations expectations;
  FieldWriter<dim> fields;
  std::vector<std::pair<std::string, std::unique_ptr<Observable<dim>>>> observed;
  std::vector<std::string> observed_names;

  unsigned int dimension = dim;
  double theta = 293., theta_start = 293.; ///< K
  std::unique_ptr<Curve> curve;
  Outcome outcome;
  std::string last_failure;
  std::string unstable_states = "reject";
  long long last_unstable = 0; ///< unstable directions at the newest row of the curve
};

} // namespace thelma
