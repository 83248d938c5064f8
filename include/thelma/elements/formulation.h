#pragma once

#include <thelma/base/named_list.h>
#include <thelma/elements/tangent_blocks.h>
#include <thelma/fields/rates.h>
#include <thelma/materials/point.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace thelma
{

/// The accepted states behind a cell's iterate, newest first, for its rates.
struct CellHistory {
  Rates rates;
  std::array<const double*, 2> x, internal;
};

/// What the points of a cell remember, one after the other.
struct CellMemory {
  const double* steps = nullptr; ///< PointHistory::step of each; null: all has relaxed
  unsigned int n_step = 0;       ///< numbers for each

  const double* old = nullptr;   ///< of the last accepted state; null: the body at rest
  const double* older = nullptr; ///< of the one before; null: there is none
  unsigned int n = 0;            ///< numbers for each point

  /// What a point remembers of the last accepted state, or of the one before it.
  const double* accepted(const std::size_t ago, const unsigned int point) const
  {
    const double* first = ago == 0 ? old : older;
    return first ? first + std::size_t(point) * n : nullptr;
  }

  PointHistory<> at(const unsigned int point) const
  {
    return {steps ? steps + std::size_t(point) * n_step : nullptr};
  }
};

/// One cell at one iterate.
template <int dim>
struct CellView {
  std::size_t index; ///< position among the rank's own cells
  const Cell<dim>& cell;
  const double* x;        ///< nodal values in the order of Cell::dofs
  const double* internal; ///< the cell's own unknowns, if its formulation has any
  double theta;           ///< uniform temperature in K where theta is no field
  bool has_temperature;
  Solved solved = Solved::all;
  const CellHistory* history = nullptr; ///< where structural heat is wanted
  bool keeps_pressures = false;         ///< the tangent leaves out what goes through PressureBlock
  double stabilisation = 0.;            ///< of the volume at points, MPa
  CellMemory memory = {};

  bool solves_deformation() const { return solved != Solved::temperature; }
  bool solves_temperature() const { return has_temperature && solved != Solved::deformation; }
};

/// What a formulation computes for one cell; begun by reset().
struct CellResult {
  template <int dim>
  void reset(const CellView<dim>& view, const unsigned int n_nodes, const bool with_tangent)
  {
    const unsigned int n_c = view.cell.n_components;
    residual.assign(with_tangent ? 0 : n_nodes * n_c, 0.);
    if (with_tangent)
      blocks.reset(n_nodes, n_c, !view.solves_temperature());
    internal.clear();
    elimination.clear();
    internal_error = 0.;
    unstable_inside = 0;
    min_det_F = std::numeric_limits<double>::max();
  }

  std::vector<double> residual;    ///< R = dPi/dx, [a][c]
  std::vector<double> internal;    ///< residual of the internal equations
  TangentBlocks blocks;            ///< of dR/dx while it is summed
  std::vector<double> tangent;     ///< dR/dx, row by row, internal unknowns condensed
  std::vector<double> elimination; ///< what condensation and recovery need of this tangent
  double min_det_F;                ///< if not positive, the rest is meaningless
  double internal_error;           ///< squared residual of the internal equations, mm^dim

  /// Directions of the condensed unknowns alone in which the cell is unstable: the negative pivots
  /// of the assembled tangent do not show them.
  int unstable_inside;
};

/// The internal unknowns of one cell in a linear system whose tangent may be an older one.
template <int dim>
struct Elimination {
  std::size_t index;               ///< position among the rank's own cells
  unsigned int n_components, heat; ///< of the cell; its component of the temperature, if it has one
  const double* kept;              ///< CellResult::elimination of the tangent
  const double* residual;          ///< CellResult::internal at the iterate
};

/// What the residuals of the fields are measured by: a stress mu in MPa, an electric displacement
/// sqrt(eps mu), a heat flux k * 1 K/mm (theory.md, eq. 82).
inline std::array<double, n_field_kinds> flux_units(const Material& material, const double theta)
{
  const double mu = material.shear_modulus(theta);
  return {{mu, std::sqrt(mu * material.permittivity(theta)), material.thermal.k}};
}

/// Values of one cell's pressure or dilatation modes; unused ones stay zero.
using Modes = std::array<double, 8>;

/// A matrix with a row and a column for each mode.
using ModeMatrix = std::array<Modes, 8>;

/// How the pressures of a cell answer to its displacements: q = S B u. Entry (i, c, a) of B is
/// gradient[(c * n + i) * stride + a].
struct PressureBlock {
  unsigned int n, stride, n_nodes;
  const double* stiffness; ///< S, row by row
  const double* gradient;
  const ModeMatrix* mass_inverse;
};

/// Residual and tangent of one cell. A new formulation is one file and one line in
/// formulation_list.cc.
template <int dim>
class Formulation
{
public:
  virtual ~Formulation() = default;

  /// Precompute quadrature data for the cells of @p layout.
  virtual void setup(const DofLayout<dim>& layout) = 0;
  virtual void residual(const CellView<dim>& view, CellResult& result) const = 0;
  virtual void tangent(const CellView<dim>& view, CellResult& result) const = 0;

  /// Its pressure dpsi_v/dJ in MPa at the point @p xi of the reference cell, in the given state.
  virtual double pressure(const CellView<dim>& view, const dealii::Point<dim>& xi,
                          const PointState<>& state) const = 0;

  /// What the volume at the points needs beyond its means, at this state; CellView::stabilisation.
  virtual double stabilisation(const CellView<dim>&) const { return 0.; }

  /// What the cell stores in mJ (in plane strain per mm): the integrals of which residual() is the
  /// derivative, once the internal equations are solved.
  virtual Energies energies(const CellView<dim>& view) const = 0;

  /// The points at which laws are evaluated and remember; what they remember at the end of a step
  /// to this state, into @p now.
  virtual const dealii::Quadrature<dim>& law_points() const = 0;
  virtual void update_memory(const CellView<dim>& view, double* now) const = 0;

  /// Internal unknowns per cell are iterates like the nodal ones, but condensed out of each linear
  /// system: eliminate() adds what they do to the nodal residual, recover() gives their correction
  /// once the nodal one, @p dx, is known.
  virtual unsigned int n_internal() const { return 0; }
  virtual unsigned int n_elimination() const { return 0; } ///< size of CellResult::elimination
  /// What they are in the stress-free body of @p material at @p theta.
  virtual void initialise_internal(const Material& /*material*/, double /*theta*/,
                                   double* /*values*/) const
  {
  }
  virtual void eliminate(const Elimination<dim>&, double* /*residual*/) const {}
  virtual void recover(const Elimination<dim>&, const double* /*dx*/, double* /*correction*/) const
  {
  }

  /// Pressures per cell that a linear solver may keep instead of condensing them, and what they do.
  virtual unsigned int n_kept_pressures() const { return 0; }
  virtual PressureBlock pressures(const Elimination<dim>&) const { return {}; }

  /// Make internal values those of an observer who deforms with the cell, so that they can be
  /// extrapolated while the body turns; and the way back.
  virtual void pull_back(const CellView<dim>&, double* /*values*/) const {}
  virtual void push_forward(const CellView<dim>&, double* /*values*/) const {}
};

template <int dim>
const NamedList<Formulation<dim>>& formulations();

template <int dim>
std::unique_ptr<Formulation<dim>> make_enhanced_strain();
template <int dim>
std::unique_ptr<Formulation<dim>> make_mean_dilatation();
template <int dim>
std::unique_ptr<Formulation<dim>> make_standard();
template <int dim>
std::unique_ptr<Formulation<dim>> make_selective_reduced();

} // namespace thelma
