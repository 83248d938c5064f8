#include <thelma/base/error.h>
#include <thelma/elements/element_pressure.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace thelma
{
namespace
{

/// Gradients dM_k/dX_J of a cell's modes at one point, [J][k].
template <int dim>
using ModeGradients = std::array<std::array<double, dim>, dim>;

/// A cell whose modes are further nodes, its matrix and right-hand side.
template <int dim>
class EnhancedCell
{
public:
  EnhancedCell(const Integration<dim>& rule, const ModeGradients<dim>* modes,
               const CellView<dim>& nodal, const double* alpha)
      : n_outer(nodal.cell.dofs.size()), n(n_outer + dim * nodal.cell.n_components), modes(modes),
        x(nodal.x, nodal.x + n_outer), view{nodal.index,    nodal.cell,  append(alpha),
                                            nodal.internal, nodal.theta, nodal.has_temperature},
        points(rule, view, [modes](const unsigned int q, Gradients<dim>& gradients) {
          for (int J = 0; J < dim; ++J)
            for (int k = 0; k < dim; ++k)
              gradients.g[J][gradients.n_nodes - dim + k] = modes[q][J][k];
        })
  {
  }

  void assemble_residual(const ElementPressure<dim>& pressure)
  {
    R.reset(n, false);
    pressure.residual(view, points, R);
  }

  void assemble_tangent(const ElementPressure<dim>& pressure)
  {
    K.reset(n, true);
    pressure.tangent(view, points, K);
  }

  /// Squared residual of the modes in the units of eq. (20).
  double mode_error() const
  {
    const Material& material = *view.cell.material;
    const double mu = material.shear_modulus(view.theta);
    const double D = std::sqrt(mu * material.permittivity(view.theta));
    const int n_c = view.cell.n_components;
    double sum = 0.;
    for (int k = 0; k < dim; ++k) {
      double size = 0.; // of the mode, 1/mm^2 over the cell
      for (unsigned int q = 0; q < points.n_points; ++q)
        for (int J = 0; J < dim; ++J)
          size += points.geometry[q].JxW * modes[q][J][k] * modes[q][J][k];
      for (int c = 0; c < n_c; ++c) {
        const double unit = c < dim                               ? mu
                            : c == dim && view.cell.has_potential ? D
                                                                  : material.thermal.k;
        const double r = R.residual[n_outer + k * n_c + c] / unit;
        sum += r * r / size;
      }
    }
    return sum;
  }

  /// Gaussian elimination of the modes, the last one first, from the rows behind @p first_row and
  /// in the columns behind @p first_column. Returns the number of negative pivots, which is that
  /// of the negative eigenvalues of a symmetric block.
  unsigned int eliminate(const std::size_t first_row, const std::size_t first_column)
  {
    double* A = K.tangent.data();
    unsigned int n_negative = 0;
    for (std::size_t k = n; k-- > n_outer;) {
      const double* row = A + k * n;
      n_negative += row[k] < 0. ? 1 : 0;
      for (std::size_t i = first_row; i < k; ++i) {
        const double factor = A[i * n + k] / row[k];
        for (std::size_t j = first_column; j < k; ++j)
          A[i * n + j] -= factor * row[j];
        if (!R.residual.empty())
          R.residual[i] -= factor * R.residual[k];
      }
    }
    return n_negative;
  }

  /// The change of nodes and modes where that of the nodes is @p dx, after elimination.
  std::vector<double> substitute(const double* dx) const
  {
    std::vector<double> change(dx, dx + n_outer);
    for (std::size_t k = n_outer; k < n; ++k) {
      const double* row = K.tangent.data() + k * n;
      const double sum = std::inner_product(change.begin(), change.end(), row, R.residual[k]);
      change.push_back(-sum / row[k]);
    }
    return change;
  }

  const std::size_t n_outer, n; ///< unknowns of the nodes, and of all

private:
  const double* append(const double* alpha)
  {
    x.insert(x.end(), alpha, alpha + (n - n_outer));
    return x.data();
  }

  const ModeGradients<dim>* modes;
  std::vector<double> x;

public:
  const CellView<dim> view;
  const CellPoints<dim> points;
  CellResult R, K;
};

/// Enhanced strain and field (theory.md, eq. 29): linear elements whose gradients have in each cell
/// dim more modes per component, those of quadratic bubbles across it. They let the cell bend
/// without shear, and the field in it vary. Pressure and dilatation are linear as well. All of
/// these are iterates of Newton's method, condensed cell by cell from the linear system only.
template <int dim>
class EnhancedStrain final : public Formulation<dim>
{
public:
  void setup(const FieldLayout<dim>& layout) override
  {
    if (layout.degree() != 1)
      throw InputError("section Discretisation, entry 'Formulation': 'enhanced strain' improves "
                       "linear elements; set Degree = 1, or Formulation = mean dilatation");
    rule.emplace(layout, 2, dim);
    centre.emplace(layout, 1);
    pressure.setup(layout, *rule, dim + 1);
    modes.clear();
    for (std::size_t cell = 0; cell < layout.cells().size(); ++cell)
      for (unsigned int q = 0; q < rule->basis().n_points; ++q)
        modes.push_back(gradients(*centre->of_cell(cell), q, rule->of_cell(cell)[q].JxW));
  }

  unsigned int n_internal() const override { return pressure.n_internal() + dim * (dim + 2); }

  void start_internal(double* values) const override
  {
    std::fill(values, values + n_internal(), 0.);
    pressure.start_internal(values);
  }

  void residual(const CellView<dim>& view, CellResult& result) const override
  {
    result.reset(view.cell.dofs.size(), false);
    EnhancedCell<dim> cell = enhance(view);
    cell.assemble_residual(pressure);
    result.min_det_F = cell.R.min_det_F;
    if (!(result.min_det_F > 0.))
      return;
    result.internal_error = cell.R.internal_error + cell.mode_error();
    cell.assemble_tangent(pressure);
    cell.eliminate(0, cell.n_outer);
    std::copy_n(cell.R.residual.begin(), cell.n_outer, result.residual.begin());
  }

  void tangent(const CellView<dim>& view, CellResult& result) const override
  {
    const std::size_t n = view.cell.dofs.size();
    result.reset(n, true);
    EnhancedCell<dim> cell = enhance(view);
    cell.assemble_tangent(pressure);
    const unsigned int n_negative = cell.eliminate(0, 0);
    for (std::size_t i = 0; i < n; ++i)
      std::copy_n(cell.K.tangent.begin() + i * cell.n, n, result.tangent.begin() + i * n);
    // One for each mode of the potential belongs to a stable cell, as in eq. (19).
    result.unstable_inside = static_cast<int>(n_negative) - (view.cell.has_potential ? dim : 0);
  }

  void recover(const CellView<dim>& view, const double* dx, double* correction) const override
  {
    EnhancedCell<dim> cell = enhance(view);
    cell.assemble_residual(pressure);
    cell.assemble_tangent(pressure);
    cell.eliminate(cell.n_outer, 0);
    const std::vector<double> change = cell.substitute(dx);
    std::fill(correction, correction + n_internal(), 0.);
    std::copy(change.begin() + cell.n_outer, change.end(), correction + pressure.n_internal());
    pressure.recover(cell.view, cell.points,
                     NodalValues<dim>(change.data(), rule->basis().n_nodes, view.cell.n_components),
                     correction);
  }

  Energies energies(const CellView<dim>& view) const override
  {
    const EnhancedCell<dim> cell = enhance(view);
    Energies sum;
    add_energies<WithoutVolumetric>(cell.points, cell.view, sum);
    sum.elastic += pressure.volumetric_energy(cell.view, cell.points);
    return sum;
  }

  void pull_back(const CellView<dim>& view, double* values) const override
  {
    transform(view, dealii::invert(centre_gradient(view)), values);
  }

  void push_forward(const CellView<dim>& view, double* values) const override
  {
    transform(view, centre_gradient(view), values);
  }

private:
  EnhancedCell<dim> enhance(const CellView<dim>& view) const
  {
    return EnhancedCell<dim>(*rule, modes.data() + view.index * rule->basis().n_points, view,
                             view.internal + pressure.n_internal());
  }

  /// (j_0 / j) times the slope of xi_k^2/2 on the cell, j_0 and the Jacobian being those of the
  /// centre: int Grad M_k dV = 0.
  ModeGradients<dim> gradients(const PointGeometry<dim>& at_centre, const unsigned int q,
                               const double JxW) const
  {
    const double ratio = at_centre.JxW * rule->quadrature().weight(q) / JxW;
    ModeGradients<dim> g;
    for (int k = 0; k < dim; ++k)
      for (int J = 0; J < dim; ++J)
        g[J][k] =
            ratio * (2. * rule->quadrature().point(q)[k] - 1.) * at_centre.inverse_jacobian[k][J];
    return g;
  }

  /// F at the centre, where the modes vanish.
  dealii::Tensor<2, dim> centre_gradient(const CellView<dim>& view) const
  {
    const Gradients<dim> gradients(centre->basis(), 0, *centre->of_cell(view.index));
    const PointState<> state = point_state(view, gradients);
    dealii::Tensor<2, dim> F;
    for (int i = 0; i < dim; ++i)
      for (int J = 0; J < dim; ++J)
        F[i][J] = state.F[axis<dim>(i)][axis<dim>(J)];
    return F;
  }

  /// Multiply the displacement of each mode by @p A.
  void transform(const CellView<dim>& view, const dealii::Tensor<2, dim>& A, double* values) const
  {
    double* alpha = values + pressure.n_internal();
    for (int k = 0; k < dim; ++k, alpha += view.cell.n_components) {
      dealii::Tensor<1, dim> a;
      std::copy_n(alpha, dim, a.begin_raw());
      a = A * a;
      std::copy_n(a.begin_raw(), dim, alpha);
    }
  }

  std::optional<Integration<dim>> rule, centre;
  ElementPressure<dim> pressure;
  std::vector<ModeGradients<dim>> modes; ///< at the points of every cell
};

} // namespace

template <int dim>
std::unique_ptr<Formulation<dim>> make_enhanced_strain()
{
  return std::make_unique<EnhancedStrain<dim>>();
}

template std::unique_ptr<Formulation<2>> make_enhanced_strain();
template std::unique_ptr<Formulation<3>> make_enhanced_strain();

} // namespace thelma
