#pragma once

#include <thelma/elements/cell_points.h>

#include <vector>

namespace thelma
{

/// The modes m_i of which the pressure and the dilatation of a cell are combinations: their values
/// at the points of one rule and, for every cell, the inverse M of their mass int m_i m_j dV. What
/// ties them to the nodal unknowns are rows over the nodes, one for each mode, [i][a], as long as
/// those of the rule's Basis.
template <int dim>
class DilatationModes
{
public:
  /// @p n modes with these @p values at the points of @p rule, in @p n_cells cells.
  DilatationModes(const Integration<dim>& rule, std::size_t n_cells, std::vector<Modes> values,
                  unsigned int n);

  /// The constant and, if @p n is dim + 1, the coordinates on the cell, at the points of Gauss's
  /// rule of @p n_points per direction.
  static std::vector<Modes> polynomials(unsigned int n_points, unsigned int n);

  /// They at any point of the reference cell.
  static Modes polynomials_at(const dealii::Point<dim>& xi, unsigned int n);

  unsigned int size() const { return n; }
  const Modes& at(const unsigned int q) const { return values[q]; }
  const ModeMatrix& mass_inverse(const std::size_t cell) const { return inverses[cell]; }

  /// M x.
  Modes apply_mass_inverse(std::size_t cell, const Modes& x) const;

  /// sum_i m_i x_i where the modes are @p m.
  double combination(const Modes& m, const double* x) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < n; ++i)
      sum += m[i] * x[i];
    return sum;
  }

  /// Numbers in the rows of all modes.
  std::size_t block_size() const { return std::size_t(n) * stride; }

  /// rows_ia = int m_i J G_cJ dN_a/dX_J: how int m_i J changes with the displacement's component
  /// @p c.
  void set_constraint(const CellPoints<dim>& points, int c, double* rows) const;

  /// rows_ia += m_i w g_a at point @p q.
  void add_rows(unsigned int q, double w, const double* g, double* rows) const;

  /// Add A_c^T S B to the block of the components c, d for c from @p first to before @p last; from
  /// the first of them on, the A_c follow each other in @p A.
  void add_product(const double* A, int first, int last, const ModeMatrix& S, const double* B,
                   int d, TangentBlocks& blocks) const;

private:
  ModeMatrix invert_mass(const PointGeometry<dim>* geometry) const;

  unsigned int n, stride;
  std::vector<Modes> values;        ///< at the points
  std::vector<ModeMatrix> inverses; ///< M, per cell
};

} // namespace thelma
