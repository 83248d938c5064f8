#pragma once

#include <thelma/elements/dilatation_modes.h>

namespace thelma
{

/// Condenses the pressure p and the dilatation t of a cell, see PressureDilatation, from its linear
/// systems (theory.md, eq. 27).
///
/// What it keeps of a tangent: S = M H M, the stabilisation, then B, the derivative of R_p by each
/// displacement component; with a temperature field also of R_t by the temperature and of the heat
/// balance by t.
template <int dim>
class PressureElimination
{
public:
  /// Of combinations of the @p modes; @p basis is that of their rule. Both must outlive this.
  PressureElimination(const DilatationModes<dim>& modes, const Basis<dim>& basis,
                      const bool has_temperature)
      : modes(modes), basis(basis), has_temperature(has_temperature)
  {
  }

  /// Size of CellResult::elimination.
  unsigned int n_kept() const;

  /// Keep what is needed of this tangent and add what p and t do to it. The pressure answers to the
  /// dilatation by @p H, at the points also to the temperature by @p dp_dtheta and to J by the
  /// @p stabilisation.
  void condense(const CellView<dim>& view, const CellPoints<dim>& points, const ModeMatrix& H,
                const double* dp_dtheta, double stabilisation, CellResult& result) const;

  /// Where the derivative of the heat balance by t is kept, zero after condense(); and what t does
  /// to the tangent through it.
  double* heat_rows(CellResult& result) const;
  void condense_heat(const CellView<dim>& view, CellResult& result) const;

  /// As those of Formulation.
  void eliminate(const Elimination<dim>& cell, double* residual) const;
  void recover(const Elimination<dim>& cell, const double* dx, double* correction) const;
  PressureBlock pressures(const Elimination<dim>& cell) const;

private:
  /// What is kept of a tangent.
  template <typename Number>
  struct Kept {
    Kept(const unsigned int n_modes, Number* start)
        : S(start), stabilisation(S + std::size_t(n_modes) * n_modes), B(stabilisation + 1)
    {
    }
    Number *S, *stabilisation, *B;
  };

  const DilatationModes<dim>& modes;
  const Basis<dim>& basis;
  bool has_temperature;
};

} // namespace thelma
