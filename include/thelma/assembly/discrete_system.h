#pragma once

#include <thelma/assembly/cell_stabilisation.h>
#include <thelma/assembly/residual_norm.h>
#include <thelma/assembly/stability.h>
#include <thelma/solvers/continuation.h>

#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// The discrete balance of a scene: sums the cells into the residual at the State's iterate and
/// corrects the iterate by means of the linearised balance.
template <int dim>
class DiscreteSystem final : public LoadedSystem
{
public:
  DiscreteSystem(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
                 const Loads<dim>& loads, const HeatStorage<dim>& storage, State& state,
                 const SystemSettings& settings, Timings& timings);

  /// Choose formulation and linear solver for the fields to be solved; the fields must stand.
  /// Throws InputError where they do not fit.
  void choose(Solved fields);

  /// Build what has been chosen; the constraints must stand.
  void setup();

  void begin() override;
  bool follow() override;
  ResidualReport residual() override;
  std::string law_defect() const override { return cells.table_defect(); }
  LinearReport linear_solve(bool reuse) override;
  void move_to(double step) override;
  double rounding() override;

  /// From now on the load factor leads along this path, which must live as long as it does. The
  /// path before.
  LoadPath* load_along(LoadPath* loads_of_path) { return std::exchange(path, loads_of_path); }
  double load() const override { return load_factor; }
  void set_load(double load) override;
  LinearReport solve_load() override;
  void add_response(double change) override;
  const Displacement& displacement() const override { return state.x.block(0); }
  const Displacement& correction() const override { return nodal_correction.block(0); }
  const Displacement& response() const override { return nodal_response.block(0); }

  /// Solve the cells' internal equations at the current nodal values; the tangent stays.
  void converge_internal();

  /// Residual before constraints: at prescribed unknowns the reactions (N; minus the charge in
  /// uC at electrodes).
  const BlockVector& reactions() const { return raw_residual; }
  BlockVector free_residual() const;

  /// Hold the body with these nodal forces, charges and heat flows (N, minus uC, mW), beside its
  /// loads.
  void hold_with(const BlockVector& forces) { holding = forces; }

  /// What enters through the walls, all of them, at the newest residual.
  HeatInflow heat_inflow() const;

  CellLoop<dim> cells;
  LinearSystem<dim> linear;
  Stability<dim> stability;

private:
  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  const Loads<dim>& loads;
  const HeatStorage<dim>& storage;
  State& state;
  const SystemSettings& settings;
  Timings& timings;

  CellStabilisation<dim> stabilisation;
  CondensedUnknowns<dim> condensed;
  ResidualNorm<dim> norm;

  BlockVector raw_residual, holding, base, nodal_correction, nodal_response;
  LoadPath* path = nullptr;
  double load_factor = 0.;
};

} // namespace thelma
