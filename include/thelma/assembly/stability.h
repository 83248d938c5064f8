#pragma once

#include <thelma/assembly/linear_system.h>

namespace thelma
{

/// In how many directions a state is unstable, and which of them is nearest to changing that, by
/// the tangent last factorised (theory.md, "Stability").
template <int dim>
class Stability
{
public:
  Stability(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
            CellLoop<dim>& cells, LinearSystem<dim>& linear)
      : layout(layout), conditions(conditions), cells(cells), linear(linear)
  {
  }

  /// From now on the unstable directions that this unsymmetric tangent does not tell are counted on
  /// that of displacement and potential alone (theory.md, eqs. 61, 62).
  void count_on(Stability& displacement_and_potential)
  {
    symmetric_part = &displacement_and_potential;
  }

  /// Whether it is known in how many directions a state is unstable: not for a tangent that is not
  /// factorised, nor before the solver is chosen.
  bool is_known() const
  {
    return linear.has_inertia() || (symmetric_part && symmetric_part->is_known());
  }

  /// What the description of the linear solver is to add.
  std::string remark() const;

  /// The negative pivots of the symmetric tangent that tells of stability at the iterate, where the
  /// tangent last factorised has @p own.
  LinearReport count_pivots(long long own);

  /// By these negative pivots, of which the tangent of a stable state has some too.
  long long unstable_directions(long long negative_pivots) const;

  /// The eigenvalue of smallest size of the tangent with all fields but the displacement
  /// eliminated, and its eigenvector of length 1 in @p mode (theory.md, eq. 65); not a number where
  /// it is not found.
  double critical_mode(BlockVector& mode);

private:
  double orientation(BlockVector& mode) const;

  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  CellLoop<dim>& cells;
  LinearSystem<dim>& linear;
  Stability* symmetric_part = nullptr;
};

} // namespace thelma
