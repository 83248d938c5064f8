#pragma once

#include <thelma/solvers/newton.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <optional>
#include <utility>

namespace thelma
{

/// A nonlinear system whose equations contain a load factor.
class LoadedSystem : public NonlinearSystem
{
public:
  using Displacement = dealii::LinearAlgebra::distributed::Vector<double>;

  virtual double load() const = 0;

  /// Write what the load prescribes into the iterate.
  virtual void set_load(double load) = 0;

  /// Find the change of the iterate per load, with the tangent of the last linear_solve().
  virtual LinearReport solve_load() = 0;

  /// Add to the correction what @p change of the load does to the iterate.
  virtual void add_response(double change) = 0;

  virtual const Displacement& displacement() const = 0; ///< of the iterate
  virtual const Displacement& correction() const = 0;
  virtual const Displacement& response() const = 0; ///< per load
};

/// A condition normal . u + load_normal * load = value that chooses one state of a path.
struct Plane {
  LoadedSystem::Displacement normal;
  double load_normal = 0., value = 0.;

  double excess(const LoadedSystem& system) const
  {
    return normal * system.displacement() + load_normal * system.load() - value;
  }
};

/// How far apart states of a path are: by its arc length, or by one chosen displacement alone.
class PathMetric
{
public:
  using Displacement = LoadedSystem::Displacement;

  /// Of the arc length: a squared displacement counts by @p factor against a squared load.
  void weigh(const double factor) { weight = factor; }

  /// From now on only the displacement @p row . u counts.
  void choose(Displacement row) { chosen = std::move(row); }

  double length(const Displacement& u, double load) const;

  /// The plane across the direction (@p u, @p load), without its place.
  Plane across(const Displacement& u, double load) const;

  /// What is known of it on the way.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& weight;
  }

private:
  double weight = 1.;
  std::optional<Displacement> chosen;
};

/// A system with its load as one more unknown and a plane as one more equation. Both right-hand
/// sides, the residual and its derivative with respect to the load, share one factorisation
/// (theory.md, eq. 64).
///
/// No tangent serves twice: in a direction in which the body has lost its stiffness since, an old
/// one blows up what rounding has left there, and the iteration ends on another path.
class BorderedSystem final : public NonlinearSystem
{
public:
  BorderedSystem(LoadedSystem& system, Plane plane) : system(system), plane(std::move(plane)) {}

  void begin() override { system.begin(); }
  bool follow() override { return system.follow(); }
  ResidualReport residual() override;
  LinearReport linear_solve(bool reuse) override;
  void move_to(double step) override;
  double rounding() override { return system.rounding(); }

private:
  LoadedSystem& system;
  Plane plane;
  double base_load = 0., load_change = 0.;
};

} // namespace thelma
