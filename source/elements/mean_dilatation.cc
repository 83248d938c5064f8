#include <thelma/elements/integrate.h>
#include <thelma/elements/modes.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <optional>

namespace thelma
{
namespace
{

/// Values at the points of a rule.
using PointValues = std::array<double, 27>;

/// The stress and stiffness of a given pressure field; the dilatation has its own energy.
struct GivenPressure {
  static constexpr bool conducts = true;
  PointValues pressure; ///< at the points of the rule, MPa

  template <typename Derivatives>
  void add(const Material& material, const PointState<>& state, const Kinematics<>& kin,
           const unsigned int q, Derivatives& d) const
  {
    material.evaluate(state, d);
    Volumetric<> constant{};
    constant.p = pressure[q];
    add_volumetric(kin, constant, d);
  }

  void add_entropy_rate(const Material& material, const PointState<>& state,
                        const PointRates& rates, EntropyRate& out) const
  {
    material.add_entropy_rate(state, rates, out);
  }
};

/// Mean dilatation (theory.md, eq. 21): inside each cell a pressure p and a dilatation t, both
/// discontinuous polynomials of degree p - 1 (Q1/P0, Q2/P1), in
///   Pi = int psi - psi_v(J) + psi_v(t) + p (J - t) dV.
/// They are iterates of Newton's method and condensed from each linear system only, so that the
/// volumetric energy never meets a displacement that is not yet in balance.
template <int dim>
class MeanDilatation final : public Formulation<dim>
{
public:
  void setup(const FieldLayout<dim>& layout) override
  {
    rule.emplace(layout, layout.degree() + 1);
    n_modes = layout.degree() == 1 ? 1 : dim + 1;
    modes.clear();
    for (const auto& point : rule->quadrature().get_points()) {
      modes.push_back({{1.}});
      for (unsigned int i = 1; i < n_modes; ++i)
        modes.back()[i] = 2. * point[i - 1] - 1.;
    }
    mass_inverse.clear();
    for (std::size_t cell = 0; cell < layout.cells().size(); ++cell)
      mass_inverse.push_back(invert_mass(rule->of_cell(cell)));
  }

  unsigned int n_internal() const override { return 2 * n_modes; }

  /// p = 0 and t = 1.
  void start_internal(double* values) const override
  {
    std::fill(values, values + n_internal(), 0.);
    values[n_modes] = 1.;
  }

  void residual(const CellView<dim>& view, CellResult& result) const override
  {
    result.reset(view.cell.dofs.size(), false);
    const CellPoints<dim> points(*rule, view);
    const Local local(*this, view, points);
    result.min_det_F = local.min_det;
    if (!(local.min_det > 0.))
      return;
    integrate(points, view, GivenPressure{at_points(local.p + local.pressure_correction())}, false,
              result);
    if (view.solves_temperature() && view.history)
      add_volumetric_heat(view, points, local, false, result);
    const double mu = view.cell.material->shear_modulus(view.theta);
    result.internal_error =
        local.R_p * (local.M * local.R_p) + local.R_t * (local.M * local.R_t) / (mu * mu);
  }

  void tangent(const CellView<dim>& view, CellResult& result) const override
  {
    result.reset(view.cell.dofs.size(), true);
    const CellPoints<dim> points(*rule, view);
    const Local local(*this, view, points);
    integrate(points, view, GivenPressure{at_points(local.p)}, true, result);
    if (view.solves_deformation())
      add_condensed(view, points, local, result.tangent.data());
    if (view.solves_temperature() && view.history)
      add_volumetric_heat(view, points, local, true, result);
  }

  void recover(const CellView<dim>& view, const double* dx, double* correction) const override
  {
    const CellPoints<dim> points(*rule, view);
    Local local(*this, view, points);
    const NodalValues<dim> change(dx, rule->basis().n_nodes, view.cell.n_components);
    for (unsigned int q = 0; q < points.n_points; ++q) {
      const Kinematics<>& kin = points.kinematics[q];
      const double w = points.geometry[q].JxW;
      double dJ = 0., dp = 0.;
      for (int i = 0; i < dim; ++i)
        for (int J = 0; J < dim; ++J)
          dJ += kin.J * kin.G[axis<dim>(i)][axis<dim>(J)] *
                change.gradient(i, J, points.gradients[q]);
      if (view.has_temperature)
        dp = local.dp_dtheta[q] * change.value(change.n_components - 1, points.gradients[q]);
      for (unsigned int i = 0; i < n_modes; ++i) {
        local.R_p[i] += w * modes[q][i] * dJ;
        local.R_t[i] += w * modes[q][i] * dp;
      }
    }
    const Modes dt = local.M * local.R_p, dp = local.pressure_correction();
    std::copy_n(dp.begin(), n_modes, correction);
    std::copy_n(dt.begin(), n_modes, correction + n_modes);
  }

private:
  /// The cell's own two equations, tested with the modes m_i:
  ///   R_p = int m (J - t) = 0,   R_t = int m (psi_v'(t) - p) = 0,
  /// with M the inverse of int m m and H = int psi_v'' m m.
  struct Local {
    Local(const MeanDilatation& f, const CellView<dim>& view, const CellPoints<dim>& points)
        : M(f.mass_inverse[view.index]), min_det(points.min_det_F)
    {
      Modes dilatation_modes{};
      std::copy_n(view.internal, f.n_modes, p.begin());
      std::copy_n(view.internal + f.n_modes, f.n_modes, dilatation_modes.begin());
      for (unsigned int q = 0; q < points.n_points; ++q) {
        const Modes& m = f.modes[q];
        const double w = points.geometry[q].JxW, dilatation = m * dilatation_modes;
        t[q] = dilatation;
        min_det = std::min(min_det, dilatation);
        if (!(min_det > 0.))
          return;
        const Volumetric<> v =
            view.cell.material->thermal.volumetric(dilatation, points.input[q].state.theta);
        for (unsigned int i = 0; i < f.n_modes; ++i) {
          R_p[i] += w * m[i] * (points.kinematics[q].J - dilatation);
          R_t[i] += w * m[i] * (v.p - m * p);
        }
        add_square(m, w * v.dp_dJ, H);
        dp_dtheta[q] = v.dp_dtheta;
      }
    }

    /// M (R_t + H M R_p): what the pressure lacks where the nodes are.
    Modes pressure_correction() const { return M * (R_t + H * (M * R_p)); }

    const ModeMatrix& M;
    ModeMatrix H{};
    Modes p{}, R_p{}, R_t{};
    std::array<double, CellPoints<dim>::max> t{}, dp_dtheta{};
    double min_det;
  };

  /// Rows over the nodes for each mode, [mode][a].
  using Rows = std::array<double, 4 * Gradients<dim>::length>;

  /// dR_p/du_c = int m J G Grad N.
  std::array<Rows, dim> derivatives_of_dilatation(const CellPoints<dim>& points) const
  {
    std::array<Rows, dim> B{};
    for (unsigned int q = 0; q < points.n_points; ++q) {
      const Kinematics<>& kin = points.kinematics[q];
      for (int c = 0; c < dim; ++c)
        for (int J = 0; J < dim; ++J)
          add_rows(modes[q], points.geometry[q].JxW * kin.J * kin.G[axis<dim>(c)][axis<dim>(J)],
                   points.gradients[q].g[J].data(), B[c].data());
    }
    return B;
  }

  /// The pressure answers to dR_p/dx by M H M and to dR_t/dtheta by M.
  void add_condensed(const CellView<dim>& view, const CellPoints<dim>& points, const Local& local,
                     double* tangent) const
  {
    const int n_c = view.cell.n_components;
    const bool heated = view.solves_temperature();
    const std::array<Rows, dim> B = derivatives_of_dilatation(points);
    Rows dR_t{};
    for (unsigned int q = 0; heated && q < points.n_points; ++q)
      add_rows(modes[q], points.geometry[q].JxW * local.dp_dtheta[q], points.gradients[q].N,
               dR_t.data());

    const ModeMatrix stiffness = local.M * local.H * local.M;
    for (int c = 0; c < dim; ++c) {
      for (int d = heated ? 0 : c; d < dim; ++d)
        add_product(B[c], stiffness, B[d], view, c, d, !heated && c != d, tangent);
      if (heated)
        add_product(B[c], local.M, dR_t, view, c, n_c - 1, false, tangent);
    }
  }

  /// Add A^T S B to the block of the components c, d.
  void add_product(const Rows& A, const ModeMatrix& S, const Rows& B, const CellView<dim>& view,
                   const int c, const int d, const bool mirrored, double* tangent) const
  {
    const unsigned int stride = rule->basis().stride, n_nodes = rule->basis().n_nodes;
    Rows answer{};
    std::array<const double*, 4> rows;
    for (unsigned int i = 0; i < n_modes; ++i) {
      rows[i] = A.data() + i * stride;
      for (unsigned int j = 0; j < n_modes; ++j)
        for (unsigned int b = 0; b < stride; ++b)
          answer[i * stride + b] += S[i][j] * B[j * stride + b];
    }
    alignas(32) std::array<double, Gradients<dim>::length * Gradients<dim>::length> C;
    multiply(stride, n_modes, rows.data(), answer.data(), n_nodes, C.data());
    add_block(C.data(), n_nodes, view.cell.n_components, c, d, mirrored, tangent);
  }

  /// theta h of the volumetric energy at the cell's own dilatation, which answers to R_p and the
  /// displacements by M.
  void add_volumetric_heat(const CellView<dim>& view, const CellPoints<dim>& points,
                           const Local& local, const bool with_tangent, CellResult& result) const
  {
    const unsigned int n_nodes = rule->basis().n_nodes, stride = rule->basis().stride;
    const int n_c = view.cell.n_components, heat = n_c - 1;
    const CellHistory& history = *view.history;
    Rows dh_dt{};
    for (unsigned int q = 0; q < points.n_points; ++q) {
      const double* shape = points.gradients[q].N;
      const double w = points.geometry[q].JxW, theta = points.input[q].state.theta;
      std::array<double, 2> t_past{}, theta_past{};
      for (std::size_t k = 0; k < history.rates.n_past; ++k) {
        for (unsigned int i = 0; i < n_modes; ++i)
          t_past[k] += modes[q][i] * history.internal[k][n_modes + i];
        for (unsigned int a = 0; a < n_nodes; ++a)
          theta_past[k] += shape[a] * history.x[k][a * n_c + heat];
      }
      const VolumetricEntropyRate rate(view.cell.material->thermal, history.rates, local.t[q],
                                       theta, t_past, theta_past);
      add_rows(modes[q], w * theta * rate.d_dt, shape, dh_dt.data());
      if (!with_tangent)
        for (unsigned int a = 0; a < n_nodes; ++a)
          result.residual[a * n_c + heat] += w * theta * rate.h * shape[a];
      else
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int b = 0; b < n_nodes; ++b)
            result.tangent[(a * n_c + heat) * n_nodes * n_c + b * n_c + heat] +=
                w * (rate.h + theta * rate.d_dtheta) * shape[a] * shape[b];
    }
    const Modes correction = local.M * local.R_p;
    if (!with_tangent)
      for (unsigned int i = 0; i < n_modes; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          result.residual[a * n_c + heat] += dh_dt[i * stride + a] * correction[i];
    else if (view.solves_deformation()) {
      const std::array<Rows, dim> B = derivatives_of_dilatation(points);
      for (int d = 0; d < dim; ++d)
        add_product(dh_dt, local.M, B[d], view, heat, d, false, result.tangent.data());
    }
  }

  /// rows_ia += m_i w g_a.
  void add_rows(const Modes& m, const double w, const double* g, double* rows) const
  {
    const unsigned int stride = rule->basis().stride;
    for (unsigned int i = 0; i < n_modes; ++i)
      for (unsigned int a = 0; a < stride; ++a)
        rows[i * stride + a] += m[i] * w * g[a];
  }

  ModeMatrix invert_mass(const PointGeometry<dim>* geometry) const
  {
    ModeMatrix sum{};
    for (std::size_t q = 0; q < modes.size(); ++q)
      add_square(modes[q], geometry[q].JxW, sum);
    dealii::FullMatrix<double> mass(n_modes, n_modes);
    for (unsigned int i = 0; i < n_modes; ++i)
      for (unsigned int j = 0; j < n_modes; ++j)
        mass(i, j) = sum[i][j];
    mass.gauss_jordan();
    ModeMatrix inverse{};
    for (unsigned int i = 0; i < n_modes; ++i)
      for (unsigned int j = 0; j < n_modes; ++j)
        inverse[i][j] = mass(i, j);
    return inverse;
  }

  /// Values at the points of the rule.
  PointValues at_points(const Modes& coefficients) const
  {
    PointValues values;
    for (std::size_t q = 0; q < modes.size(); ++q)
      values[q] = modes[q] * coefficients;
    return values;
  }

  std::optional<Integration<dim>> rule;
  unsigned int n_modes = 0;
  std::vector<Modes> modes;             ///< m_i at the points of the rule
  std::vector<ModeMatrix> mass_inverse; ///< per cell
};

} // namespace

template <int dim>
std::unique_ptr<Formulation<dim>> make_mean_dilatation()
{
  return std::make_unique<MeanDilatation<dim>>();
}

template std::unique_ptr<Formulation<2>> make_mean_dilatation();
template std::unique_ptr<Formulation<3>> make_mean_dilatation();

} // namespace thelma
