#include <thelma/elements/element_pressure.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <numeric>

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
};

Modes operator+(Modes x, const Modes& y)
{
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] += y[i];
  return x;
}

double operator*(const Modes& x, const Modes& y)
{
  return std::inner_product(x.begin(), x.end(), y.begin(), 0.);
}

Modes operator*(const ModeMatrix& A, const Modes& x)
{
  return {{A[0] * x, A[1] * x, A[2] * x, A[3] * x}};
}

/// A B of symmetric matrices.
ModeMatrix operator*(const ModeMatrix& A, const ModeMatrix& B)
{
  ModeMatrix C;
  for (std::size_t i = 0; i < C.size(); ++i)
    C[i] = B * A[i];
  return C;
}

/// A += w m x m.
void add_square(const Modes& m, const double w, ModeMatrix& A)
{
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t j = 0; j < m.size(); ++j)
      A[i][j] += w * m[i] * m[j];
}

/// A field's values at the points of the rule.
PointValues at_points(const std::vector<Modes>& modes, const Modes& coefficients)
{
  PointValues values;
  for (std::size_t q = 0; q < modes.size(); ++q)
    values[q] = modes[q] * coefficients;
  return values;
}

/// rows_ia += m_i w g_a.
void add_rows(const Modes& m, const unsigned int n_modes, const double w, const double* g,
              const unsigned int stride, double* rows)
{
  for (unsigned int i = 0; i < n_modes; ++i)
    for (unsigned int a = 0; a < stride; ++a)
      rows[i * stride + a] += m[i] * w * g[a];
}

} // namespace

/// The cell's own two equations, tested with the modes m_i:
///   R_p = int m (J - t) = 0,   R_t = int m (psi_v'(t) - p) = 0,
/// with M the inverse of int m m and H = int psi_v'' m m.
template <int dim>
struct ElementPressure<dim>::Local {
  Local(const ElementPressure& f, const CellView<dim>& view, const CellPoints<dim>& points)
      : M(f.mass_inverse[view.index]), min_det(points.min_det_F)
  {
    Modes t{};
    std::copy_n(view.internal, f.n_modes, p.begin());
    std::copy_n(view.internal + f.n_modes, f.n_modes, t.begin());
    for (unsigned int q = 0; q < points.n_points; ++q) {
      const Modes& m = f.modes[q];
      const double w = points.geometry[q].JxW, dilatation = m * t;
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
      psi += w * v.psi;
    }
  }

  /// M (R_t + H M R_p): what the pressure lacks where the nodes are.
  Modes pressure_correction() const { return M * (R_t + H * (M * R_p)); }

  const ModeMatrix& M;
  ModeMatrix H{};
  Modes p{}, R_p{}, R_t{};
  std::array<double, CellPoints<dim>::max> dp_dtheta{};
  double psi = 0.; ///< integral of psi_v(t)
  double min_det;
};

template <int dim>
void ElementPressure<dim>::setup(const FieldLayout<dim>& layout, const Integration<dim>& rule,
                                 const unsigned int n_modes_)
{
  n_modes = n_modes_;
  modes.clear();
  for (const auto& point : rule.quadrature().get_points()) {
    modes.push_back({{1.}});
    for (unsigned int i = 1; i < n_modes; ++i)
      modes.back()[i] = 2. * point[i - 1] - 1.;
  }
  mass_inverse.clear();
  for (std::size_t cell = 0; cell < layout.cells().size(); ++cell)
    mass_inverse.push_back(invert_mass(rule.of_cell(cell)));
}

template <int dim>
void ElementPressure<dim>::start_internal(double* values) const
{
  std::fill(values, values + n_internal(), 0.);
  values[n_modes] = 1.;
}

template <int dim>
double ElementPressure<dim>::volumetric_energy(const CellView<dim>& view,
                                               const CellPoints<dim>& points) const
{
  return Local(*this, view, points).psi;
}

template <int dim>
void ElementPressure<dim>::residual(const CellView<dim>& view, const CellPoints<dim>& points,
                                    CellResult& result) const
{
  const Local local(*this, view, points);
  result.min_det_F = local.min_det;
  if (!(local.min_det > 0.))
    return;
  integrate(points, view, GivenPressure{at_points(modes, local.p + local.pressure_correction())},
            false, result);
  const double mu = view.cell.material->shear_modulus(view.theta);
  result.internal_error =
      local.R_p * (local.M * local.R_p) + local.R_t * (local.M * local.R_t) / (mu * mu);
}

template <int dim>
void ElementPressure<dim>::tangent(const CellView<dim>& view, const CellPoints<dim>& points,
                                   CellResult& result) const
{
  const Local local(*this, view, points);
  integrate(points, view, GivenPressure{at_points(modes, local.p)}, true, result);
  add_condensed(view, points, local, result.tangent.data());
}

template <int dim>
void ElementPressure<dim>::recover(const CellView<dim>& view, const CellPoints<dim>& points,
                                   const NodalValues<dim>& change, double* correction) const
{
  Local local(*this, view, points);
  for (unsigned int q = 0; q < points.n_points; ++q) {
    const Kinematics<>& kin = points.kinematics[q];
    const double w = points.geometry[q].JxW;
    double dJ = 0., dp = 0.;
    for (int i = 0; i < dim; ++i)
      for (int J = 0; J < dim; ++J)
        dJ +=
            kin.J * kin.G[axis<dim>(i)][axis<dim>(J)] * change.gradient(i, J, points.gradients[q]);
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

template <int dim>
void ElementPressure<dim>::add_condensed(const CellView<dim>& view, const CellPoints<dim>& points,
                                         const Local& local, double* tangent) const
{
  constexpr unsigned int length = Gradients<dim>::length;
  using Rows = std::array<double, 4 * length>; // [mode][a]
  const unsigned int stride = points.gradients[0].stride, n_nodes = points.gradients[0].n_nodes;
  const int n_c = view.cell.n_components;
  std::array<Rows, dim + 2> B{}; // of R_p by displacement components; of R_t by the last
  for (unsigned int q = 0; q < points.n_points; ++q) {
    const Kinematics<>& kin = points.kinematics[q];
    const Gradients<dim>& gradients = points.gradients[q];
    const double w = points.geometry[q].JxW;
    for (int c = 0; c < dim; ++c)
      for (int J = 0; J < dim; ++J)
        add_rows(modes[q], n_modes, w * kin.J * kin.G[axis<dim>(c)][axis<dim>(J)],
                 gradients.g[J].data(), stride, B[c].data());
    if (view.has_temperature)
      add_rows(modes[q], n_modes, w * local.dp_dtheta[q], gradients.N, stride, B[n_c - 1].data());
  }

  const ModeMatrix stiffness = local.M * local.H * local.M;
  alignas(32) std::array<double, length * length> C;
  for (int c = 0; c < dim; ++c) {
    std::array<const double*, 4> rows;
    for (unsigned int i = 0; i < n_modes; ++i)
      rows[i] = B[c].data() + i * stride;
    for (int d = view.has_temperature ? 0 : c; d < n_c; ++d) {
      const bool heat = view.has_temperature && d == n_c - 1;
      if (d >= dim && !heat)
        continue;
      const ModeMatrix& answer = heat ? local.M : stiffness;
      Rows pressure{};
      for (unsigned int i = 0; i < n_modes; ++i)
        for (unsigned int j = 0; j < n_modes; ++j)
          for (unsigned int b = 0; b < stride; ++b)
            pressure[i * stride + b] += answer[i][j] * B[d][j * stride + b];
      multiply(stride, n_modes, rows.data(), pressure.data(), n_nodes, C.data());
      add_block(C.data(), n_nodes, n_c, c, d, !view.has_temperature && c != d, tangent);
    }
  }
}

template <int dim>
ModeMatrix ElementPressure<dim>::invert_mass(const PointGeometry<dim>* geometry) const
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

template class ElementPressure<2>;
template class ElementPressure<3>;

} // namespace thelma
