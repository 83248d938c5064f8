#include <thelma/elements/pressure_dilatation.h>

namespace thelma
{

/// R -= -B^T (M R_t + S R_p): what the pressure lacks where the nodes are; and what the dilatation
/// lacks in the heat balance.
template <int dim>
void PressureDilatation<dim>::eliminate(const Elimination<dim>& cell, double* residual) const
{
  const unsigned int n_modes = modes->size();
  const std::size_t block_size = modes->block_size();
  const ModeMatrix& M = modes->mass_inverse(cell.index);
  const Kept<const double> kept(n_modes, cell.kept);
  const double *S = kept.S, *B = kept.B, *R_p = cell.residual, *R_t = R_p + n_modes;
  const unsigned int stride = rule().basis().stride, n_nodes = rule().basis().n_nodes;
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
void PressureDilatation<dim>::recover(const Elimination<dim>& cell, const double* dx,
                                      double* correction) const
{
  const unsigned int n_modes = modes->size();
  const std::size_t block_size = modes->block_size();
  const ModeMatrix& M = modes->mass_inverse(cell.index);
  const Kept<const double> kept(n_modes, cell.kept);
  const double *S = kept.S, *B = kept.B;
  const unsigned int stride = rule().basis().stride, n_nodes = rule().basis().n_nodes;
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
PressureBlock PressureDilatation<dim>::pressures(const Elimination<dim>& cell) const
{
  const auto& basis = rule().basis();
  const unsigned int n_modes = modes->size();
  const ModeMatrix& M = modes->mass_inverse(cell.index);
  const Kept<const double> kept(n_modes, cell.kept);
  return {n_modes, basis.stride, basis.n_nodes, kept.S, kept.B, &M};
}

#define INSTANTIATE(dim)                                                                           \
  template void PressureDilatation<dim>::eliminate(const Elimination<dim>&, double*) const;        \
  template void PressureDilatation<dim>::recover(const Elimination<dim>&, const double*, double*)  \
      const;                                                                                       \
  template PressureBlock PressureDilatation<dim>::pressures(const Elimination<dim>&) const;
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
