#pragma once

#include <thelma/assembly/tangent_matrix.h>
#include <thelma/elements/basis.h>
#include <thelma/fields/state.h>
#include <thelma/solvers/mumps.h>

#include <memory>
#include <optional>
#include <vector>

namespace thelma
{

/// What reversing the load factor does to the solution: nothing is known of it, or it is the same
/// but for the sign of the potential.
enum class LoadSymmetry { none, voltage };

/// Guesses the state at a new load from the accepted ones (theory.md, "Prediction").
///
/// Polynomials do not follow a body that rolls up: its points move along circles. So not the
/// displacement is extrapolated but the deformation gradient, F = R U, the rotation by its vector
/// and the stretch by its components; the displacement is the one whose gradient comes nearest.
template <int dim>
class Predictor
{
public:
  Predictor(const FieldLayout<dim>& layout, const BoundaryConditions<dim>& conditions, State& state)
      : layout(layout), conditions(conditions), state(state)
  {
  }

  /// The fields and constraints must stand.
  void setup();

  /// Write the guess at @p load into the State's iterate.
  void predict(double load, LoadSymmetry symmetry);

private:
  void factorise();
  void guess_displacement(const std::vector<double>& weights);

  const FieldLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  State& state;
  std::optional<Integration<dim>> rule;
  std::unique_ptr<Mumps> laplacian; ///< of each displacement component; null until needed
  BlockVector moments;
};

} // namespace thelma
