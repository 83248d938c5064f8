#pragma once

#include <thelma/elements/integrate.h>
#include <thelma/elements/pressure_elimination.h>

#include <optional>

namespace thelma
{

/// Formulations in which the volumetric energy sees a dilatation t of the cell instead of J, tied
/// to it by a pressure p (theory.md, eq. 26):
///   Pi = int psi - psi_v(J) + psi_v(t) + p (J - t) dV.
/// p and t are iterates of Newton's method and condensed from each linear system only, so that the
/// volumetric energy never meets a displacement that is not yet in balance (eq. (27)).
///
/// Internal unknowns: p, then t, condensed by PressureElimination.
template <int dim>
class PressureDilatation : public Formulation<dim>
{
public:
  unsigned int n_internal() const override { return 2 * modes->size(); }
  unsigned int n_elimination() const override { return elimination().n_kept(); }

  /// p = 0 and t = J_theta.
  void initialise_internal(const Material& material, double theta, double* values) const override;

  void residual(const CellView<dim>& view, CellResult& result) const override;
  void tangent(const CellView<dim>& view, CellResult& result) const override;
  void eliminate(const Elimination<dim>& cell, double* residual) const override
  {
    elimination().eliminate(cell, residual);
  }
  void recover(const Elimination<dim>& cell, const double* dx, double* correction) const override
  {
    elimination().recover(cell, dx, correction);
  }
  unsigned int n_kept_pressures() const override { return modes->size(); }
  PressureBlock pressures(const Elimination<dim>& cell) const override
  {
    return elimination().pressures(cell);
  }
  double pressure(const CellView<dim>& view, const dealii::Point<dim>& xi,
                  const PointState<>& state) const override;
  double stabilisation(const CellView<dim>& view) const override;
  Energies energies(const CellView<dim>& view) const override;
  const dealii::Quadrature<dim>& law_points() const override { return full->quadrature(); }
  void update_memory(const CellView<dim>& view, double* now) const override;

protected:
  /// Take the volumetric terms by Gauss's rule of @p n_points per direction and let p and t be
  /// combinations of @p n_modes modes, given by their @p values at its points. A cell has
  /// @p n_enhanced modes after its nodes, see enhance().
  void use(const DofLayout<dim>& layout, unsigned int n_points, const std::vector<Modes>& values,
           unsigned int n_modes, unsigned int n_enhanced = 0);

  /// The modes at any point of the reference cell: polynomials, unless overridden.
  virtual Modes modes_at(const dealii::Point<dim>& xi) const;

  /// Set the gradients of the modes after the nodes at one point.
  virtual void enhance(std::size_t /*cell*/, unsigned int /*q*/, Gradients<dim>&) const {}

private:
  struct Local;

  /// Call @p action with the points of the full rule and those of the volumetric terms.
  template <typename Action>
  void with_points(const CellView<dim>& view, const Action& action) const;
  void integrate_energy(const CellView<dim>& view, const CellPoints<dim>& full,
                        const CellPoints<dim>& volumetric, const Local& local, bool with_tangent,
                        CellResult& result) const;
  void add_heat(const CellView<dim>& view, const CellPoints<dim>& points, bool with_tangent,
                CellResult& result) const;
  const Integration<dim>& rule() const { return reduced ? *reduced : *full; }
  PressureElimination<dim> elimination() const { return {*modes, rule().basis(), has_temperature}; }

  std::optional<Integration<dim>> full, reduced; ///< reduced: empty if it is the full rule
  std::optional<DilatationModes<dim>> modes;     ///< at the points of rule()
  bool has_temperature = false;
};

} // namespace thelma
