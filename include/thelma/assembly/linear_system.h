#pragma once

#include <thelma/assembly/condensed_unknowns.h>
#include <thelma/assembly/floating_electrodes.h>
#include <thelma/assembly/heat_storage.h>
#include <thelma/assembly/p1_coarse_spaces.h>
#include <thelma/assembly/pressure_blocks.h>
#include <thelma/assembly/system_settings.h>
#include <thelma/assembly/tangent_matrix.h>
#include <thelma/base/timings.h>
#include <thelma/loads/loads.h>

#include <memory>
#include <string>
#include <vector>

namespace thelma
{

/// The linearised balance at one state: its tangent, the linear solver that is made ready for it,
/// and the electrodes that float.
template <int dim>
class LinearSystem
{
public:
  LinearSystem(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
               const Loads<dim>& loads, const HeatStorage<dim>& storage, const State& state,
               CellLoop<dim>& cells, CondensedUnknowns<dim>& condensed,
               const SystemSettings& settings, Timings& timings);

  /// Choose the solver for the fields that the cells solve for. Throws InputError.
  void choose();

  /// Build the matrix; the constraints must stand.
  void setup();

  /// Assemble the tangent at the iterate; then make the solver ready for it.
  void assemble();
  LinearReport factorise();

  /// Whether the tangent last factorised is that of the electrodes that float now.
  bool is_current() const { return electrodes.is_current(); }

  /// What factorise() has cost last, LinearReport::cost.
  double cost() const { return last_cost; }

  /// Replace minus a nodal residual by the correction that belongs to it; the charges of floating
  /// electrodes lack @p charges.
  LinearReport solve(BlockVector& vector, const std::vector<double>& charges);

  const dealii::TrilinosWrappers::BlockSparseMatrix& matrix() const { return tangent.matrix(); }
  const FloatingElectrodes<dim>& floating() const { return electrodes; }

  /// Directions in which cells are unstable by themselves, at the tangent last assembled.
  int unstable_inside() const { return n_unstable_inside; }

  bool is_symmetric() const
  {
    return !layout.has(Field::temperature) || cells.solved() != Solved::all;
  }

  /// Whether its factorisation tells the number of negative pivots; whether solves take iterations;
  /// whether factors would be too large. No to all before the solver is chosen.
  bool has_inertia() const { return solver && solver->has_inertia(); }
  bool iterates() const { return solver && solver->iterates(); }
  bool uses_multigrid() const { return solver && solver->uses_multigrid(); }

  /// Which linear solver serves, and why.
  std::string description() const
  {
    return "linear solver: " + choice.solver + ", because " + choice.reason;
  }

private:
  void keep_pressures();
  LinearReport prepare();

  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  const Loads<dim>& loads;
  const HeatStorage<dim>& storage;
  const State& state;
  CellLoop<dim>& cells;
  CondensedUnknowns<dim>& condensed;
  const SystemSettings& settings;
  Timings& timings;

  TangentMatrix<dim> tangent;
  FloatingElectrodes<dim> electrodes;
  LinearChoice choice;
  std::unique_ptr<PressureBlocks<dim>> pressures; ///< of a solver that keeps them
  std::unique_ptr<P1CoarseSpaces<dim>> coarse_spaces;
  std::unique_ptr<LinearSolver> solver; ///< refers to both
  double last_cost = 1.;
  int n_unstable_inside = 0;
};

} // namespace thelma
