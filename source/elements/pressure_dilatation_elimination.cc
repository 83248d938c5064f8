#include <thelma/elements/pressure_dilatation.h>

namespace thelma
{

/// rows_ia = int m_i J G_cJ dN_a/dX_J: how R_p changes with the displacement's component @p c.
template <int dim>
void PressureDilatation<dim>::set_constraint(const CellPoints<dim>& points, const int c,
                                             double* rows) const
{
  const unsigned int stride = rule().basis().stride;
  double cofactor[CellPoints<dim>::max][dim];
  for (unsigned int q = 0; q < points.n_points; ++q)
    for (int J = 0; J < dim; ++J)
      cofactor[q][J] =
          points.geometry[q].JxW * points.J(q) * points.G(q, axis<dim>(c), axis<dim>(J));
  for (unsigned int a = 0; a < stride; a += 4) {
    Register sums[8] = {};
    for (unsigned int q = 0; q < points.n_points; ++q) {
      Register change{};
      for (int J = 0; J < dim; ++J)
        change += cofactor[q][J] * *reinterpret_cast<const Register*>(&points.gradients[q].g[J][a]);
      for (unsigned int i = 0; i < n_modes; ++i)
        sums[i] += modes[q][i] * change;
    }
    for (unsigned int i = 0; i < n_modes; ++i)
      *reinterpret_cast<Register*>(rows + std::size_t(i) * stride + a) = sums[i];
  }
}

/// rows_ia += m_i w g_a.
template <int dim>
void PressureDilatation<dim>::add_rows(const Modes& m, const double w, const double* g,
                                       double* rows) const
{
  const unsigned int stride = rule().basis().stride;
  for (unsigned int i = 0; i < n_modes; ++i)
    for (unsigned int a = 0; a < stride; ++a)
      rows[i * stride + a] += m[i] * w * g[a];
}

/// Add A_c^T S B to the block of the components c, d for c from @p first to before @p last; from
/// the first of them on, the A_c follow each other in @p A.
template <int dim>
void PressureDilatation<dim>::add_product(const double* A, const int first, const int last,
                                          const ModeMatrix& S, const double* B, const int d,
                                          CellResult& result) const
{
  const unsigned int stride = rule().basis().stride;
  alignas(64) std::array<double, 8 * Gradients<dim>::length> answer;
  std::fill_n(answer.begin(), block_size(), 0.);
  for (unsigned int i = 0; i < n_modes; ++i)
    for (unsigned int j = 0; j < n_modes; ++j)
      for (unsigned int b = 0; b < stride; ++b)
        answer[i * stride + b] += S[i][j] * B[j * stride + b];
  std::array<const double*, 8> rows;
  for (int c = first; c < last; ++c, A += block_size()) {
    for (unsigned int i = 0; i < n_modes; ++i)
      rows[i] = A + std::size_t(i) * stride;
    result.blocks.add_product(c, d, n_modes, rows.data(), answer.data());
  }
}

/// R -= -B^T (M R_t + S R_p): what the pressure lacks where the nodes are; and what the dilatation
/// lacks in the heat balance.
template <int dim>
void PressureDilatation<dim>::eliminate(const Elimination<dim>& cell, double* residual) const
{
  const ModeMatrix& M = mass_inverse[cell.index];
  const Kept<const double> kept(*this, cell.kept);
  const double *S = kept.S, *B = kept.B, *R_p = cell.residual, *R_t = R_p + n_modes;
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
      residual[a * cell.n_components + cell.heat] +=
          t * B[(dim + 1) * block_size() + i * stride + a];
  }
}

/// dt = M (R_p + B dx), dp = M (R_t + dR_t/dtheta dtheta) + (S + kappa M) (R_p + B dx).
template <int dim>
void PressureDilatation<dim>::recover(const Elimination<dim>& cell, const double* dx,
                                      double* correction) const
{
  const ModeMatrix& M = mass_inverse[cell.index];
  const Kept<const double> kept(*this, cell.kept);
  const double *S = kept.S, *B = kept.B;
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
        R_t[i] += B[dim * block_size() + i * stride + a] * dx[a * n_c + cell.heat];
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
  const Kept<const double> kept(*this, cell.kept);
  return {n_modes, basis.stride, basis.n_nodes, kept.S, kept.B, &mass_inverse[cell.index]};
}

template void PressureDilatation<2>::set_constraint(const CellPoints<2>&, int, double*) const;
template void PressureDilatation<2>::add_rows(const Modes&, double, const double*, double*) const;
template void PressureDilatation<3>::set_constraint(const CellPoints<3>&, int, double*) const;
template void PressureDilatation<3>::add_rows(const Modes&, double, const double*, double*) const;
template void PressureDilatation<2>::add_product(const double*, int, int, const ModeMatrix&,
                                                 const double*, int, CellResult&) const;
template void PressureDilatation<2>::eliminate(const Elimination<2>&, double*) const;
template void PressureDilatation<2>::recover(const Elimination<2>&, const double*, double*) const;
template PressureBlock PressureDilatation<2>::pressures(const Elimination<2>&) const;
template PressureBlock PressureDilatation<3>::pressures(const Elimination<3>&) const;
template void PressureDilatation<3>::add_product(const double*, int, int, const ModeMatrix&,
                                                 const double*, int, CellResult&) const;
template void PressureDilatation<3>::eliminate(const Elimination<3>&, double*) const;
template void PressureDilatation<3>::recover(const Elimination<3>&, const double*, double*) const;

} // namespace thelma
