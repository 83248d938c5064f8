#include <thelma/elements/pressure_elimination.h>

#include <algorithm>

namespace thelma
{

template <int dim>
unsigned int PressureElimination<dim>::n_kept() const
{
  const unsigned int n = modes.size();
  return n * n + 1 + (dim + (has_temperature ? 2 : 0)) * modes.block_size();
}

/// The pressure answers to B dx by S = M H M and to dR_t/dtheta by M.
template <int dim>
void PressureElimination<dim>::condense(const CellView<dim>& view, const CellPoints<dim>& points,
                                        const ModeMatrix& H, const double* dp_dtheta,
                                        const double stabilisation, CellResult& result) const
{
  const unsigned int n_modes = modes.size();
  const std::size_t block_size = modes.block_size();
  const ModeMatrix& M = modes.mass_inverse(view.index);
  result.elimination.assign(n_kept(), 0.);
  const Kept<double> kept(n_modes, result.elimination.data());
  double *S = kept.S, *B = kept.B;
  for (unsigned int i = 0; i < n_modes; ++i)
    for (unsigned int j = 0; j < n_modes; ++j) {
      S[i * n_modes + j] = -stabilisation * M[i][j];
      for (unsigned int k = 0; k < n_modes; ++k)
        for (unsigned int l = 0; l < n_modes; ++l)
          S[i * n_modes + j] += M[i][k] * H[k][l] * M[l][j];
    }
  *kept.stabilisation = stabilisation;

  for (int c = 0; c < dim; ++c)
    modes.set_constraint(points, c, B + c * block_size);
  if (has_temperature)
    for (unsigned int q = 0; q < points.n_points; ++q)
      modes.add_rows(q, points.geometry[q].JxW * dp_dtheta[q], points.gradients[q].N,
                     B + dim * block_size);

  if (!view.solves_deformation())
    return;
  ModeMatrix stiffness{};
  for (unsigned int i = 0; i < n_modes; ++i)
    std::copy_n(S + std::size_t(i) * n_modes, n_modes, stiffness[i].begin());
  if (!view.keeps_pressures)
    for (int d = 0; d < dim; ++d)
      modes.add_product(B, 0, view.solves_temperature() ? dim : d + 1, stiffness,
                        B + d * block_size, d, result.blocks);
  if (view.solves_temperature())
    modes.add_product(B, 0, dim, M, B + dim * block_size, view.cell.n_components - 1,
                      result.blocks);
}

template <int dim>
double* PressureElimination<dim>::heat_rows(CellResult& result) const
{
  return Kept<double>(modes.size(), result.elimination.data()).B + (dim + 1) * modes.block_size();
}

/// The dilatation answers to the displacements by M B.
template <int dim>
void PressureElimination<dim>::condense_heat(const CellView<dim>& view, CellResult& result) const
{
  if (!view.solves_deformation())
    return;
  const int heat = view.cell.component(Field::temperature);
  const double* B = Kept<double>(modes.size(), result.elimination.data()).B;
  for (int d = 0; d < dim; ++d)
    modes.add_product(heat_rows(result), heat, heat + 1, modes.mass_inverse(view.index),
                      B + d * modes.block_size(), d, result.blocks);
}

/// R -= -B^T (M R_t + S R_p): what the pressure lacks where the nodes are; and what the dilatation
/// lacks in the heat balance.
template <int dim>
void PressureElimination<dim>::eliminate(const Elimination<dim>& cell, double* residual) const
{
  const unsigned int n_modes = modes.size();
  const std::size_t block_size = modes.block_size();
  const ModeMatrix& M = modes.mass_inverse(cell.index);
  const Kept<const double> kept(n_modes, cell.kept);
  const double *S = kept.S, *B = kept.B, *R_p = cell.residual, *R_t = R_p + n_modes;
  const std::size_t stride = basis.stride;
  const unsigned int n_nodes = basis.n_nodes;
  for (unsigned int i = 0; i < n_modes; ++i) {
    double p = 0.;
    for (unsigned int j = 0; j < n_modes; ++j)
      p += M[i][j] * R_t[j] + S[i * n_modes + j] * R_p[j];
    for (int c = 0; c < dim; ++c)
      for (unsigned int a = 0; a < n_nodes; ++a)
        residual[a * cell.n_components + c] += p * B[c * block_size + i * stride + a];
    if (!has_temperature)
      continue;
    double t = 0.;
    for (unsigned int j = 0; j < n_modes; ++j)
      t += M[i][j] * R_p[j];
    for (unsigned int a = 0; a < n_nodes; ++a)
      residual[a * cell.n_components + cell.heat] += t * B[(dim + 1) * block_size + i * stride + a];
  }
}

/// dt = M (R_p + B dx), dp = M (R_t + dR_t/dtheta dtheta) + (S + kappa M) (R_p + B dx).
template <int dim>
void PressureElimination<dim>::recover(const Elimination<dim>& cell, const double* dx,
                                       double* correction) const
{
  const unsigned int n_modes = modes.size();
  const std::size_t block_size = modes.block_size();
  const ModeMatrix& M = modes.mass_inverse(cell.index);
  const Kept<const double> kept(n_modes, cell.kept);
  const double *S = kept.S, *B = kept.B;
  const std::size_t stride = basis.stride;
  const unsigned int n_nodes = basis.n_nodes;
  const int n_c = cell.n_components;
  Modes R_p{}, R_t{};
  std::copy_n(cell.residual, n_modes, R_p.begin());
  std::copy_n(cell.residual + n_modes, n_modes, R_t.begin());
  for (unsigned int i = 0; i < n_modes; ++i)
    for (unsigned int a = 0; a < n_nodes; ++a) {
      for (int c = 0; c < dim; ++c)
        R_p[i] += B[c * block_size + i * stride + a] * dx[a * n_c + c];
      if (has_temperature)
        R_t[i] += B[dim * block_size + i * stride + a] * dx[a * n_c + cell.heat];
    }
  for (unsigned int i = 0; i < n_modes; ++i) {
    double &p = correction[i], &t = correction[n_modes + i];
    p = t = 0.;
    for (unsigned int j = 0; j < n_modes; ++j) {
      p += M[i][j] * R_t[j] + S[i * n_modes + j] * R_p[j];
      t += M[i][j] * R_p[j];
    }
    p += *kept.stabilisation * t;
  }
}

template <int dim>
PressureBlock PressureElimination<dim>::pressures(const Elimination<dim>& cell) const
{
  const unsigned int n_modes = modes.size();
  const ModeMatrix& M = modes.mass_inverse(cell.index);
  const Kept<const double> kept(n_modes, cell.kept);
  return {n_modes, basis.stride, basis.n_nodes, kept.S, kept.B, &M};
}

template class PressureElimination<2>;
template class PressureElimination<3>;

} // namespace thelma
