#include <thelma/elements/pressure_dilatation.h>

namespace thelma
{

/// Add theta h of the volumetric energy, which sees the cell's own dilatation. In a linear system
/// the dilatation answers to the displacements by M B.
template <int dim>
void PressureDilatation<dim>::add_heat(const CellView<dim>& view, const CellPoints<dim>& points,
                                       const bool with_tangent, CellResult& result) const
{
  if (!view.solves_temperature() || !view.history)
    return;
  const unsigned int n_nodes = rule().basis().n_nodes;
  const int n_c = view.cell.n_components, heat = view.cell.component(Field::temperature);
  const CellHistory& history = *view.history;
  const std::size_t block_size = modes->block_size();
  double* B = Kept<double>(modes->size(), result.elimination.data()).B;
  double* dh_dt = B + (dim + 1) * block_size;
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
  if (with_tangent && view.solves_deformation())
    for (int d = 0; d < dim; ++d)
      modes->add_product(dh_dt, heat, heat + 1, modes->mass_inverse(view.index), B + d * block_size,
                         d, result.blocks);
}

template void PressureDilatation<2>::add_heat(const CellView<2>&, const CellPoints<2>&, bool,
                                              CellResult&) const;
template void PressureDilatation<3>::add_heat(const CellView<3>&, const CellPoints<3>&, bool,
                                              CellResult&) const;

} // namespace thelma
