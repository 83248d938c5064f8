#pragma once

#include <thelma/base/input_errors.h>
#include <thelma/base/timings.h>
#include <thelma/output/observables/observables.h>
#include <thelma/strategies/predictor.h>

#include <functional>
#include <string>
#include <vector>

namespace thelma
{

/// What is simulated: the body, what holds and drives it, and its equations. Knows no formula.
template <int dim>
class Model
{
public:
  Model(MPI_Comm comm, const ParameterFile& file, Timings& timings);

  void declare(dealii::ParameterHandler& prm);

  /// Set up all that may find fault with the scene whose files are in @p folder, @p found collects
  /// what is wrong; @p visit is shown the mesh. Whether layout and conditions stand.
  struct Parts {
    bool layout = false, conditions = false;
  };
  Parts check(const std::string& folder, const std::function<void(const WholeMesh<dim>&)>& visit,
              InputErrors& found);

  /// Allocate what the solvers need.
  void setup();

  /// What is solved for and how, and what is to be doubted, a sentence to a line.
  std::vector<std::string> summary() const;

  double theta = 293.; ///< uniform or initial temperature in K
  Timings& timings;
  MaterialLibrary materials;
  Mesh<dim> mesh;
  DofLayout<dim> layout;
  BoundaryConditions<dim> conditions;
  Loading loading;
  Loads<dim> loads;
  HeatStorage<dim> storage;
  State state;
  SystemSettings settings;
  DiscreteSystem<dim> system;
  DiscreteSystem<dim>
      isothermal;             ///< counts the unstable directions of states of a steady temperature
  DiscreteSystem<dim> heated; ///< of a transient temperature, or of everything
  Predictor<dim> predictor;

private:
  enum class StaticStates { relaxed, instantaneous };

  std::string doubt_about_thickness() const;

  StaticStates static_states = StaticStates::relaxed;
};

} // namespace thelma
