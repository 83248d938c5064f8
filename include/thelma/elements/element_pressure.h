#pragma once

#include <thelma/elements/integrate.h>

#include <array>
#include <vector>

namespace thelma
{

/// Coefficients of a pressure or dilatation, and matrices over them; unused ones stay zero.
using Modes = std::array<double, 4>;
using ModeMatrix = std::array<Modes, 4>;

/// The pressure p and the dilatation t of every cell (theory.md, eq. 21), discontinuous
/// polynomials with one or dim + 1 modes, in
///   Pi = int psi - psi_v(J) + psi_v(t) + p (J - t) dV.
/// They are iterates of Newton's method and condensed from each linear system only, so that the
/// volumetric energy never meets a displacement that is not yet in balance. The @p points may
/// have more modes of displacement than those of the nodes.
template <int dim>
class ElementPressure
{
public:
  /// Points and cells are those of @p rule.
  void setup(const FieldLayout<dim>& layout, const Integration<dim>& rule, unsigned int n_modes);

  /// The coefficients of p, then those of t.
  unsigned int n_internal() const { return 2 * n_modes; }

  /// p = 0 and t = 1.
  void start_internal(double* values) const;

  void residual(const CellView<dim>& view, const CellPoints<dim>& points, CellResult& result) const;
  void tangent(const CellView<dim>& view, const CellPoints<dim>& points, CellResult& result) const;
  void recover(const CellView<dim>& view, const CellPoints<dim>& points,
               const NodalValues<dim>& change, double* correction) const;

  /// Integral of psi_v(t) in mJ, in plane strain per mm.
  double volumetric_energy(const CellView<dim>& view, const CellPoints<dim>& points) const;

private:
  struct Local;

  void add_condensed(const CellView<dim>& view, const CellPoints<dim>& points, const Local& local,
                     double* tangent) const;
  ModeMatrix invert_mass(const PointGeometry<dim>* geometry) const;

  unsigned int n_modes = 0;
  std::vector<Modes> modes;             ///< m_i at the points of the rule
  std::vector<ModeMatrix> mass_inverse; ///< per cell
};

} // namespace thelma
