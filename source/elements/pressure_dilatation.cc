#include <thelma/elements/pressure_dilatation.h>
#include <thelma/elements/stabilisation.h>

namespace thelma
{
namespace
{

/// Values at the points of a rule and in the lanes that belong to none.
using PointValues = std::array<double, 32>;

/// The stress and stiffness of a pressure that is given but for its answer to J.
template <bool whole>
struct GivenPressure {
  static constexpr bool conducts = whole;
  PointValues pressure; ///< at the points of the rule, MPa
  double stabilisation; ///< its change per J, MPa

  template <typename Number, typename Derivatives>
  void add(const Material& material, const PointState<Number>& state, const Kinematics<Number>& kin,
           const unsigned int q, Derivatives& d) const
  {
    if constexpr (whole)
      material.evaluate(state, d);
    Volumetric<Number> constant{};
    constant.p = load<Number>(pressure.data() + q);
    constant.dp_dJ = Number(stabilisation);
    add_volumetric(kin, constant, d);
  }

  void add_entropy_rate(const Material& material, const PointState<>& state,
                        const PointRates& rates, EntropyRate& out) const
  {
    material.add_entropy_rate(state, rates, out);
  }
};

} // namespace

/// The cell's own two equations, tested with the modes m_i:
///   R_p = int m (J - t) = 0,   R_t = int m (psi_v'(t) - p) = 0,
/// with H = int psi_v'' m m.
template <int dim>
struct PressureDilatation<dim>::Local {
  Local(const PressureDilatation& f, const CellView<dim>& view, const CellPoints<dim>& points)
      : stabilisation(f.reduced ? 0. : view.stabilisation), min_det(points.min_det_F)
  {
    const unsigned int n = f.modes->size();
    const double *pressures = view.internal, *dilatations = view.internal + n;
    for (unsigned int q = 0; q < points.n_points; ++q) {
      const Modes& m = f.modes->at(q);
      double pressure = 0., dilatation = 0.;
      for (unsigned int i = 0; i < n; ++i) {
        pressure += m[i] * pressures[i];
        dilatation += m[i] * dilatations[i];
      }
      min_det = std::min(min_det, dilatation);
      if (!(min_det > 0.))
        return;
      const double excess = points.J(q) - dilatation;
      pressure_at[q] = pressure + stabilisation * excess;
      const double w = points.geometry[q].JxW;
      const Volumetric<> v = view.cell.material->thermal.volumetric(dilatation, points.theta(q));
      for (unsigned int i = 0; i < n; ++i) {
        R_p[i] += w * m[i] * excess;
        R_t[i] += w * m[i] * (v.p - pressure);
        for (unsigned int j = 0; j < n; ++j)
          H[i][j] += w * v.dp_dJ * m[i] * m[j];
      }
      dp_dtheta[q] = v.dp_dtheta;
      stored.add(w, thelma::energies(v, points.theta(q)));
      stored.elastic += w * stabilisation / 2. * excess * excess;
    }
  }

  double stabilisation; ///< MPa
  ModeMatrix H{};
  Modes R_p{}, R_t{};
  PointValues pressure_at{}; ///< with the stabilisation's part
  std::array<double, CellPoints<dim>::max> dp_dtheta{};
  double min_det;
  Energies stored; ///< of psi_v(t)
};

template <int dim>
void PressureDilatation<dim>::use(const DofLayout<dim>& layout, const unsigned int n_points,
                                  const std::vector<Modes>& values, const unsigned int n,
                                  const unsigned int n_enhanced)
{
  full.emplace(layout, layout.degree() + 1, n_enhanced);
  if (n_points != layout.degree() + 1)
    reduced.emplace(layout, n_points, n_enhanced);
  has_temperature = layout.has(Field::temperature);
  modes.emplace(rule(), layout.cells().size(), values, n);
}

template <int dim>
void PressureDilatation<dim>::initialise_internal(const Material& material, const double theta,
                                                  double* values) const
{
  std::fill(values, values + n_internal(), 0.);
  // The modes are either points, or polynomials of which the first is the constant.
  const unsigned int n_modes = modes->size();
  std::fill(values + n_modes, values + n_modes + (reduced ? n_modes : 1),
            std::pow(material.thermal.split(theta), -3));
}

template <int dim>
template <typename Action>
void PressureDilatation<dim>::with_points(const CellView<dim>& view, const Action& action) const
{
  const CellPoints<dim> points(*full, view, [&](const unsigned int q, Gradients<dim>& gradients) {
    enhance(view.index, q, gradients);
  });
  if (!reduced)
    return action(points, points);
  CellView<dim> volume = view;
  volume.memory = {}; // that of the full rule's points
  action(points, CellPoints<dim>(*reduced, volume));
}

template <int dim>
void PressureDilatation<dim>::residual(const CellView<dim>& view, CellResult& result) const
{
  result.reset(view, rule().basis().n_nodes, false);
  with_points(view, [&](const CellPoints<dim>& points, const CellPoints<dim>& own) {
    const Local local(*this, view, own);
    result.min_det_F = local.min_det;
    if (!(local.min_det > 0.))
      return;
    integrate_energy(view, points, own, local, false, result);
    add_heat(view, own, false, result);
    const unsigned int n_modes = modes->size();
    result.internal.assign(local.R_p.begin(), local.R_p.begin() + n_modes);
    result.internal.insert(result.internal.end(), local.R_t.begin(), local.R_t.begin() + n_modes);
    const Modes p = modes->apply_mass_inverse(view.index, local.R_p),
                t = modes->apply_mass_inverse(view.index, local.R_t);
    const double mu = view.cell.material->shear_modulus(view.theta);
    for (unsigned int i = 0; i < n_modes; ++i)
      result.internal_error += local.R_p[i] * p[i] + local.R_t[i] * t[i] / (mu * mu);
  });
}

template <int dim>
void PressureDilatation<dim>::tangent(const CellView<dim>& view, CellResult& result) const
{
  result.reset(view, rule().basis().n_nodes, true);
  with_points(view, [&](const CellPoints<dim>& points, const CellPoints<dim>& own) {
    const Local local(*this, view, own);
    integrate_energy(view, points, own, local, true, result);
    elimination().condense(view, own, local.H, local.dp_dtheta.data(), local.stabilisation, result);
    add_heat(view, own, true, result);
  });
  result.blocks.write(result.tangent);
}

/// The largest need of its points. Not quite the whole bulk modulus, so that the answer of the mean
/// pressure (S of PressureElimination) stays positive.
template <int dim>
double PressureDilatation<dim>::stabilisation(const CellView<dim>& view) const
{
  constexpr double part = 0.999;
  const double dilatation = view.internal[modes->size()];
  double needed = 0.;
  if (reduced || !view.cell.has_potential || !(dilatation > 0.))
    return needed;
  const Material& material = *view.cell.material;
  with_points(view, [&](const CellPoints<dim>& points, const CellPoints<dim>&) {
    for (unsigned int q = 0; q < points.n_points; ++q) {
      const double pressure = modes->combination(modes->at(q), view.internal);
      const double most = part * material.thermal.volumetric(dilatation, points.theta(q)).dp_dJ;
      PointState<> relaxed = points.state(q); // or a body at rest would not stay so in time
      relaxed.history = {};
      needed = std::max(needed, needed_stabilisation(material, relaxed, pressure, dim, most));
    }
  });
  return needed;
}

template <int dim>
Modes PressureDilatation<dim>::modes_at(const dealii::Point<dim>& xi) const
{
  return DilatationModes<dim>::polynomials_at(xi, modes->size());
}

/// Without the part of the stabilisation, whose mean over the cell is zero.
template <int dim>
double PressureDilatation<dim>::pressure(const CellView<dim>& view, const dealii::Point<dim>& xi,
                                         const PointState<>&) const
{
  return modes->combination(modes_at(xi), view.internal);
}

template <int dim>
void PressureDilatation<dim>::update_memory(const CellView<dim>& view, double* now) const
{
  with_points(view, [&](const CellPoints<dim>& points, const CellPoints<dim>&) {
    thelma::update_memory(points, view, now);
  });
}

template <int dim>
Energies PressureDilatation<dim>::energies(const CellView<dim>& view) const
{
  Energies sum;
  with_points(view, [&](const CellPoints<dim>& points, const CellPoints<dim>& own) {
    sum = integral(points, view, [](const Material& material, const PointState<>& state) {
      return material.energies(state);
    });
    sum.add(1., Local(*this, view, own).stored);
  });
  return sum;
}

template <int dim>
void PressureDilatation<dim>::integrate_energy(const CellView<dim>& view,
                                               const CellPoints<dim>& points,
                                               const CellPoints<dim>& own, const Local& local,
                                               const bool with_tangent, CellResult& result) const
{
  const PointValues& p = local.pressure_at;
  if (!reduced)
    return integrate(points, view, GivenPressure<true>{p, local.stabilisation}, with_tangent,
                     result);
  integrate(points, view, WithoutVolumetric(), with_tangent, result);
  integrate(own, view, GivenPressure<false>{p, 0.}, with_tangent, result);
}

/// Add theta h of the volumetric energy, which sees the cell's own dilatation.
template <int dim>
void PressureDilatation<dim>::add_heat(const CellView<dim>& view, const CellPoints<dim>& points,
                                       const bool with_tangent, CellResult& result) const
{
  if (!view.solves_temperature() || !view.history)
    return;
  const unsigned int n_nodes = rule().basis().n_nodes;
  const int n_c = view.cell.n_components, heat = view.cell.component(Field::temperature);
  const CellHistory& history = *view.history;
  double* dh_dt = with_tangent ? elimination().heat_rows(result) : nullptr;
  for (unsigned int q = 0; q < points.n_points; ++q) {
    const double* N = points.gradients[q].N;
    const double w = points.geometry[q].JxW, theta = points.theta(q);
    const auto dilatation = [&](const double* internal) {
      return modes->combination(modes->at(q), internal + modes->size());
    };
    std::array<double, 2> t_past{}, theta_past{};
    for (std::size_t k = 0; k < history.rates.n_past; ++k) {
      t_past[k] = dilatation(history.internal[k]);
      for (unsigned int a = 0; a < n_nodes; ++a)
        theta_past[k] += N[a] * history.x[k][a * n_c + heat];
    }
    const VolumetricEntropyRate rate(view.cell.material->thermal, history.rates,
                                     dilatation(view.internal), theta, t_past, theta_past);
    if (!with_tangent) {
      for (unsigned int a = 0; a < n_nodes; ++a)
        result.residual[a * n_c + heat] += w * theta * rate.h * N[a];
      continue;
    }
    modes->add_rows(q, w * theta * rate.d_dt, N, dh_dt);
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int b = 0; b < n_nodes; ++b)
        result.blocks.entry(heat, heat, a, b) += w * (rate.h + theta * rate.d_dtheta) * N[a] * N[b];
  }
  if (with_tangent)
    elimination().condense_heat(view, result);
}

template class PressureDilatation<2>;
template class PressureDilatation<3>;

} // namespace thelma
