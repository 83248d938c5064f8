#include <thelma/elements/pressure_dilatation.h>

namespace thelma
{

/// Add A^T S B to the block of the components c, d and, @p mirrored, its transpose.
template <int dim>
void PressureDilatation<dim>::add_product(const double* A, const ModeMatrix& S, const double* B,
                                          const CellView<dim>& view, const int c, const int d,
                                          const bool mirrored, CellResult& result) const
{
  constexpr unsigned int length = Gradients<dim>::length;
  const unsigned int stride = rule().basis().stride, n_nodes = rule().basis().n_nodes;
  alignas(32) std::array<double, length * length> C;
  std::array<double, 8 * length> answer;
  std::array<const double*, 8> rows;
  std::fill_n(answer.begin(), block_size(), 0.);
  for (unsigned int i = 0; i < n_modes; ++i) {
    rows[i] = A + i * stride;
    for (unsigned int j = 0; j < n_modes; ++j)
      for (unsigned int b = 0; b < stride; ++b)
        answer[i * stride + b] += S[i][j] * B[j * stride + b];
  }
  multiply(stride, n_modes, rows.data(), answer.data(), n_nodes, C.data());
  add_block(C.data(), n_nodes, view.cell.n_components, c, d, mirrored, result.tangent.data());
}

/// R -= -B^T (M R_t + S R_p): what the pressure lacks where the nodes are; and what the dilatation
/// lacks in the heat balance.
template <int dim>
void PressureDilatation<dim>::eliminate(const Elimination<dim>& cell, double* residual) const
{
  const ModeMatrix& M = mass_inverse[cell.index];
  const double *S = cell.kept, *B = S + n_modes * n_modes, *R_p = cell.residual,
               *R_t = R_p + n_modes;
  const unsigned int stride = rule().basis().stride, n_nodes = rule().basis().n_nodes;
  for (unsigned int i = 0; i < n_modes; ++i) {
    double p = 0.;
    for (unsigned int j = 0; j < n_modes; ++j)
      p += M[i][j] * R_t[j] + S[i * n_modes + j] * R_p[j];
    for (int c = 0; c < dim; ++c)
      for (unsigned int a = 0; a < n_nodes; ++a)
        residual[a * cell.n_components + c] += p * B[c * block_size() + i * stride + a];
    if (!has_temperature)
      continue;
    double t = 0.;
    for (unsigned int j = 0; j < n_modes; ++j)
      t += M[i][j] * R_p[j];
    for (unsigned int a = 0; a < n_nodes; ++a)
      residual[(a + 1) * cell.n_components - 1] += t * B[(dim + 1) * block_size() + i * stride + a];
  }
}

/// dt = M (R_p + B dx), dp = M (R_t + dR_t/dtheta dtheta) + S (R_p + B dx).
template <int dim>
void PressureDilatation<dim>::recover(const Elimination<dim>& cell, const double* dx,
                                      double* correction) const
{
  const ModeMatrix& M = mass_inverse[cell.index];
  const double *S = cell.kept, *B = S + n_modes * n_modes;
  const unsigned int stride = rule().basis().stride, n_nodes = rule().basis().n_nodes;
  const int n_c = cell.n_components;
  Modes R_p{}, R_t{};
  std::copy_n(cell.residual, n_modes, R_p.begin());
  std::copy_n(cell.residual + n_modes, n_modes, R_t.begin());
  for (unsigned int i = 0; i < n_modes; ++i)
    for (unsigned int a = 0; a < n_nodes; ++a) {
      for (int c = 0; c < dim; ++c)
        R_p[i] += B[c * block_size() + i * stride + a] * dx[a * n_c + c];
      if (has_temperature)
        R_t[i] += B[dim * block_size() + i * stride + a] * dx[a * n_c + n_c - 1];
    }
  for (unsigned int i = 0; i < n_modes; ++i) {
    double &p = correction[i], &t = correction[n_modes + i];
    p = t = 0.;
    for (unsigned int j = 0; j < n_modes; ++j) {
      p += M[i][j] * R_t[j] + S[i * n_modes + j] * R_p[j];
      t += M[i][j] * R_p[j];
    }
  }
}

template <int dim>
PressureBlock PressureDilatation<dim>::pressures(const Elimination<dim>& cell) const
{
  const auto& basis = rule().basis();
  return {n_modes,
          basis.stride,
          basis.n_nodes,
          cell.kept,
          cell.kept + n_modes * n_modes,
          &mass_inverse[cell.index]};
}

template void PressureDilatation<2>::add_product(const double*, const ModeMatrix&, const double*,
                                                 const CellView<2>&, int, int, bool,
                                                 CellResult&) const;
template void PressureDilatation<2>::eliminate(const Elimination<2>&, double*) const;
template void PressureDilatation<2>::recover(const Elimination<2>&, const double*, double*) const;
template PressureBlock PressureDilatation<2>::pressures(const Elimination<2>&) const;
template PressureBlock PressureDilatation<3>::pressures(const Elimination<3>&) const;
template void PressureDilatation<3>::add_product(const double*, const ModeMatrix&, const double*,
                                                 const CellView<3>&, int, int, bool,
                                                 CellResult&) const;
template void PressureDilatation<3>::eliminate(const Elimination<3>&, double*) const;
template void PressureDilatation<3>::recover(const Elimination<3>&, const double*, double*) const;

} // namespace thelma
