#pragma once

#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/dof_layout.h>
#include <thelma/solvers/linear_solver.h>

#include <deal.II/lac/full_matrix.h>

#include <utility>
#include <vector>

namespace thelma
{

/// The potentials of electrodes whose charge is given, as a border of the tangent: the matrix
/// itself holds them, and its pattern is the same whether an electrode floats or not (theory.md,
/// eq. 68).
template <int dim>
class FloatingElectrodes
{
public:
  FloatingElectrodes(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions)
      : layout(layout), conditions(conditions)
  {
  }

  /// The fields and electrodes must stand. Nothing floats where the potential is not among what is
  /// solved for.
  void setup(bool potential_is_solved);

  /// Charges in uC of the floating electrodes at @p applied charge.
  std::vector<double> charges(double applied) const;

  /// Sums of the owned entries of @p x over each floating electrode and all ranks.
  std::vector<double> sums(const BlockVector& x) const;

  /// Begin a new assembly, add the tangent of the own cell @p index, and end it.
  void clear();
  void add(std::size_t index, const Cell<dim>& cell, const std::vector<double>& entries);
  LinearReport finish(LinearSolver& solver);

  /// Whether the border is that of the electrodes that float now.
  bool is_current() const { return floating == now_floating(); }

  /// Complete the correction @p x at held potentials, so that the sum of the correction's nodal
  /// charges over each electrode is that of @p right_side.
  void correct(const std::vector<double>& right_side, BlockVector& x) const;

  /// Negative pivots that the border adds to the tangent.
  long long negative_pivots() const;

private:
  std::vector<std::size_t> now_floating() const;

  using Touch = std::pair<std::size_t, std::size_t>; ///< electrode, local unknown

  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  bool is_solved = true;
  std::vector<std::vector<Touch>> touches; ///< of each own cell
  std::vector<std::size_t> floating;       ///< electrodes in the border
  std::vector<BlockVector> columns, rows, responses;
  dealii::FullMatrix<double> capacitance; ///< minus the charge per potential
};

} // namespace thelma
