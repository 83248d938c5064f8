#pragma once

#include <thelma/elements/formulation.h>
#include <thelma/fields/boundary_conditions.h>
#include <thelma/solvers/linear_solver.h>

#include <functional>
#include <vector>

namespace thelma
{

/// The pressures of all own cells, applied cell by cell from what the formulation keeps of the
/// tangent: no matrix is built for them.
template <int dim>
class PressureBlocks final : public CellPressures
{
public:
  using CellElimination = std::function<Elimination<dim>(std::size_t)>;

  PressureBlocks(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
                 const Formulation<dim>& formulation, CellElimination elimination);

  /// Take over a new tangent; @p shear_modulus in MPa of each own cell.
  void update(const std::function<double(std::size_t)>& shear_modulus);

  Vector new_vector() const override { return Vector(owned, layout.communicator()); }
  void add_forces(const Vector& q, Vector& forces) const override;
  void apply(const Vector& u, const Vector& q, Vector& residual) const override;
  void apply_inverse_schur(const Vector& residual, Vector& q) const override;
  Vector inverse_scales() const override;

private:
  /// y = A x cell by cell, A stored row by row.
  void multiply(const std::vector<double>& A, const Vector& x, Vector& y) const;
  PressureBlock block(const std::size_t cell) const
  {
    return formulation.pressures(elimination(cell));
  }

  const DofLayout<dim>& layout;
  const Formulation<dim>& formulation;
  CellElimination elimination;
  unsigned int n; ///< pressures per cell
  dealii::IndexSet owned;
  std::vector<unsigned int> given;               ///< own displacements without equation
  std::vector<double> compliance, inverse_schur; ///< n x n of every cell
  mutable Vector scratch;                        ///< of displacements, with ghosts
};

} // namespace thelma
