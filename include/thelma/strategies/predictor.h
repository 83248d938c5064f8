#pragma once

#include <thelma/elements/formulation.h>
#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/state.h>
#include <thelma/solvers/continuation.h>
#include <thelma/strategies/gradient_fit.h>
#include <thelma/strategies/interpolation.h>

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
/// Where a path bends sharply, as at a bifurcation, high orders mislead: the order is the highest
/// that has lately served and does not point back.
template <int dim>
class Predictor
{
public:
  Predictor(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions, State& state)
      : layout(layout), conditions(conditions), state(state)
  {
  }

  /// The fields and constraints must stand; @p formulation must live as long as this. A body whose
  /// tangents are too large to be factorised @p is_large.
  void setup(const Formulation<dim>& formulation, bool is_large);

  /// Write the guess at @p load into the State's iterate.
  void predict(double load, LoadSymmetry symmetry);

  /// The same at @p place of a path on which the accepted states stand at @p places by this
  /// @p metric, also between the last two; returns the load there.
  double extrapolate_along(const std::vector<double>& places, double place,
                           const PathMetric& metric);

  /// Write the @p part of the way from the last accepted state to @p found into the State's
  /// iterate.
  void between(const State::Accepted& found, double part);

  /// Write a better guess of the deformation once the temperature of the iterate is known: by the
  /// weights with which the accepted states make this temperature best.
  void follow_temperature();

  /// How far the iterate, now converged, lies from the guess, as a part of its distance from the
  /// last accepted state. Above 1 it is probably on another branch.
  double prediction_error() const;

  /// Choose the next order by the prediction_error of the accepted state, or after a failure.
  void adapt(double prediction_error);

  /// From the last accepted state on the path has another direction: what came before foretells
  /// nothing.
  void turn() { order = 0; }

  /// What it has learnt on the way.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& order;
  }

private:
  /// The accepted states by which a guess is made and where they stand, the newest last.
  struct Supports {
    std::vector<double> places;
    std::vector<State::Accepted> states;
  };

  /// As many of the newest states at @p places as serve a guess at @p place.
  Supports supports(const std::vector<double>& places, double place) const;
  double extrapolate(Supports path, double place, Parity parity, const PathMetric* metric);
  bool turns_back(const Supports& path, double place, double load, const PathMetric* metric) const;

  /// Write the sum of the states of the @p path: @p even weighs them for all fields that reversing
  /// the load does not reverse, @p odd for the others.
  void combine(const std::vector<State::Accepted>& path, const std::vector<double>& even,
               const std::vector<double>& odd);
  void follow_cells(const std::vector<State::Accepted>& path, const std::vector<double>& weights);

  static constexpr unsigned int highest_order = 3;

  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  State& state;
  const Formulation<dim>* formulation = nullptr;
  std::optional<GradientFit<dim>> fit;
  BlockVector guess;
  unsigned int order = highest_order;
};

} // namespace thelma
