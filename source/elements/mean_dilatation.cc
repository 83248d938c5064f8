#include <thelma/elements/integrate.h>

#include <deal.II/lac/full_matrix.h>

#include <optional>

namespace thelma
{
namespace
{

/// The stress and stiffness of a given pressure field; the dilatation has its own energy.
struct GivenPressure {
  static constexpr bool conducts = true;
  const std::vector<double>& pressure; ///< at the points of the rule, MPa

  template <typename Derivatives>
  void add(const Material& material, const PointState<>& state, const Kinematics<>& kin,
           const unsigned int q, Derivatives& d) const
  {
    material.evaluate(state, d);
    Volumetric<> constant{};
    constant.p = pressure[q];
    add_volumetric(kin, constant, d);
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
    for (const auto& point : rule->quadrature().get_points())
      for (unsigned int i = 0; i < n_modes; ++i)
        modes.push_back(i == 0 ? 1. : 2. * point[i - 1] - 1.);
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
    const std::vector<double> pressure = interpolate(view.internal);
    integrate(*rule, view, GivenPressure{pressure}, false, result);
    const Local local(*this, view);
    result.min_det_F = std::min(result.min_det_F, local.min_dilatation);
    const double mu = view.cell.material->shear_modulus(view.theta);
    result.internal_error = local.mass_inverse.matrix_norm_square(local.R_p) +
                            local.mass_inverse.matrix_norm_square(local.R_t) / (mu * mu);
  }

  void tangent(const CellView<dim>& view, CellResult& result) const override
  {
    const std::size_t n = view.cell.dofs.size();
    result.reset(n, true);
    const std::vector<double> pressure = interpolate(view.internal);
    integrate(*rule, view, GivenPressure{pressure}, true, result);
    if (!view.has_temperature)
      mirror(n, result.tangent.data());

    const Local local(*this, view);
    const dealii::FullMatrix<double> stiffness = local.stiffness();
    const dealii::Vector<double> correction = local.pressure_correction();
    for (unsigned int i = 0; i < n_modes; ++i) {
      std::vector<double> row(n, 0.); // of d(pressure mode i)/dx
      for (unsigned int j = 0; j < n_modes; ++j)
        for (std::size_t b = 0; b < n; ++b)
          row[b] += stiffness(i, j) * local.B[j * n + b] +
                    local.mass_inverse(i, j) * local.dR_t_dx[j * n + b];
      for (std::size_t a = 0; a < n; ++a) {
        const double B = local.B[i * n + a];
        result.residual[a] += B * correction(i);
        if (B != 0.)
          for (std::size_t b = 0; b < n; ++b)
            result.tangent[a * n + b] += B * row[b];
      }
    }
  }

  void recover(const CellView<dim>& view, const double* dx, double* correction) const override
  {
    const std::size_t n = view.cell.dofs.size();
    const Local local(*this, view);
    dealii::Vector<double> R_p = local.R_p, R_t = local.R_t, dp(n_modes), dt(n_modes);
    for (unsigned int i = 0; i < n_modes; ++i)
      for (std::size_t b = 0; b < n; ++b) {
        R_p(i) += local.B[i * n + b] * dx[b];
        R_t(i) += local.dR_t_dx[i * n + b] * dx[b];
      }
    local.mass_inverse.vmult(dt, R_p);
    local.H.vmult_add(R_t, dt);
    local.mass_inverse.vmult(dp, R_t);
    for (unsigned int i = 0; i < n_modes; ++i) {
      correction[i] = dp(i);
      correction[n_modes + i] = dt(i);
    }
  }

private:
  /// The cell's own two equations, tested with the modes m_i:
  ///   R_p = int m (J - t) = 0,   R_t = int m (psi_v'(t) - p) = 0,
  /// and their derivatives: M = int m m, H = int psi_v'' m m, B = dR_p/dx, dR_t/dx (heat).
  struct Local {
    Local(const MeanDilatation& f, const CellView<dim>& view)
        : mass_inverse(f.n_modes, f.n_modes), H(f.n_modes, f.n_modes), R_p(f.n_modes),
          R_t(f.n_modes), B(f.n_modes * view.cell.dofs.size(), 0.), dR_t_dx(B)
    {
      const auto* geometry = f.rule->of_cell(view.index);
      for (unsigned int q = 0; q < f.rule->basis().n_points; ++q)
        add_point(f, view, q, Gradients<dim>(f.rule->basis(), q, geometry[q]), geometry[q].JxW);
      if (min_dilatation > 0.)
        mass_inverse.gauss_jordan();
    }

    void add_point(const MeanDilatation& f, const CellView<dim>& view, const unsigned int q,
                   const Gradients<dim>& gradients, const double w)
    {
      const std::size_t n = view.cell.dofs.size(), n_c = view.cell.n_components;
      const double* m = f.modes.data() + q * f.n_modes;
      const PointState<> state = point_state(view, gradients);
      const Kinematics<> kin(state.F);
      double p = 0., t = 0.;
      for (unsigned int i = 0; i < f.n_modes; ++i) {
        p += m[i] * view.internal[i];
        t += m[i] * view.internal[f.n_modes + i];
      }
      min_dilatation = std::min(min_dilatation, std::min(t, kin.J));
      if (!(min_dilatation > 0.))
        return;
      const Volumetric<> v = view.cell.material->thermal.volumetric(t, state.theta);
      for (unsigned int i = 0; i < f.n_modes; ++i) {
        R_p(i) += w * m[i] * (kin.J - t);
        R_t(i) += w * m[i] * (v.p - p);
        for (unsigned int j = 0; j < f.n_modes; ++j) {
          mass_inverse(i, j) += w * m[i] * m[j];
          H(i, j) += w * v.dp_dJ * m[i] * m[j];
        }
        for (unsigned int a = 0; a < gradients.n_nodes; ++a) {
          for (int c = 0; c < dim; ++c)
            for (int J = 0; J < dim; ++J)
              B[i * n + a * n_c + c] +=
                  w * m[i] * kin.J * kin.G[axis<dim>(c)][axis<dim>(J)] * gradients.g[J][a];
          if (view.has_temperature)
            dR_t_dx[i * n + a * n_c + n_c - 1] += w * m[i] * v.dp_dtheta * gradients.N[a];
        }
      }
    }

    /// M^-1 H M^-1: how the pressure answers to B dx.
    dealii::FullMatrix<double> stiffness() const
    {
      dealii::FullMatrix<double> result(H.m(), H.m());
      result.triple_product(H, mass_inverse, mass_inverse);
      return result;
    }

    /// M^-1 (R_t + H M^-1 R_p): the pressure correction at dx = 0.
    dealii::Vector<double> pressure_correction() const
    {
      dealii::Vector<double> dt(R_p.size()), rhs = R_t, dp(R_p.size());
      mass_inverse.vmult(dt, R_p);
      H.vmult_add(rhs, dt);
      mass_inverse.vmult(dp, rhs);
      return dp;
    }

    dealii::FullMatrix<double> mass_inverse, H;
    dealii::Vector<double> R_p, R_t;
    std::vector<double> B, dR_t_dx; ///< [i][local dof]
    double min_dilatation = std::numeric_limits<double>::max();
  };

  /// Pressure at the points of the rule.
  std::vector<double> interpolate(const double* coefficients) const
  {
    std::vector<double> values(rule->basis().n_points, 0.);
    for (std::size_t q = 0; q < values.size(); ++q)
      for (unsigned int i = 0; i < n_modes; ++i)
        values[q] += modes[q * n_modes + i] * coefficients[i];
    return values;
  }

  std::optional<Integration<dim>> rule;
  unsigned int n_modes = 0;
  std::vector<double> modes; ///< m_i at the points of the rule, [q][i]
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
