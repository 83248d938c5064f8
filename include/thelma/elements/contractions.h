#pragma once

#include <thelma/elements/basis.h>
#include <thelma/elements/point_fluxes.h>
#include <thelma/elements/tangent_blocks.h>

#include <array>

/// The hot loops of assembly. Rows over nodes are padded to whole vector registers.
namespace thelma
{

/// Gradients dN_a/dX_J of all nodes at one point, [J][a]; in a body of revolution followed by
/// N_a/R, the stretch around its axis.
template <int dim>
struct Gradients {
  static constexpr unsigned int length = padded(Basis<dim>::max_nodes);

  Gradients() = default;
  Gradients(const Basis<dim>& basis, const unsigned int q, const PointGeometry<dim>& point)
  {
    set(basis, q, point);
  }

  /// In place: most of the rows of a linear element are unused, and would be copied.
  void set(const Basis<dim>& basis, const unsigned int q, const PointGeometry<dim>& point)
  {
    n_nodes = basis.n_nodes;
    stride = basis.stride;
    N = basis.N.data() + std::size_t(q) * stride;
    const double* reference = basis.dN.data() + std::size_t(q) * dim * stride;
    for (int J = 0; J < dim; ++J)
      for (unsigned int a = 0; a < stride; ++a) {
        double sum = 0.;
        for (int K = 0; K < dim; ++K)
          sum += point.inverse_jacobian[K][J] * reference[K * stride + a];
        g[J][a] = sum;
      }
    is_axisymmetric = point.curvature > 0.;
    if (dim == 2 && is_axisymmetric)
      for (unsigned int a = 0; a < stride; ++a)
        g[2][a] = point.curvature * N[a];
  }

  int n_directions() const { return dim == 3 || is_axisymmetric ? 3 : 2; }

  unsigned int n_nodes, stride;
  const double* N;
  bool is_axisymmetric;
  std::array<std::array<double, length>, 3> g;
};

/// Four doubles in one register, wherever they lie.
using Register = double __attribute__((vector_size(32), aligned(8), may_alias));

/// Nodal values of one cell, [a][c], padded to two registers per node, of which few components need
/// one.
template <int dim>
struct NodalValues {
  static constexpr unsigned int width = 4, n_registers = 2; ///< doubles in a register
  using Components = std::array<double, std::size_t(n_registers) * width>;

  NodalValues(const double* x, const unsigned int n_nodes, const unsigned int n_c)
      : n_nodes(n_nodes), n_components(n_c)
  {
    for (unsigned int a = 0; a < n_nodes; ++a)
      for (unsigned int c = 0; c < n_registers * width; ++c)
        rows[c / width][a][c % width] = c < n_c ? x[a * n_c + c] : 0.;
  }

  /// sum_a x_ac N_a for all components c.
  Components value(const Gradients<dim>& gradients) const { return sum(gradients.N); }

  /// sum_a x_ac dN_a/dX_J for all directions J and components c.
  std::array<Components, 3> gradient(const Gradients<dim>& gradients) const
  {
    std::array<Components, 3> result;
    for (int J = 0; J < gradients.n_directions(); ++J)
      result[J] = sum(gradients.g[J].data());
    return result;
  }

  unsigned int n_nodes, n_components;

private:
  Components sum(const double* weights) const
  {
    Components result{};
    for (unsigned int r = 0; r * width < n_components; ++r) {
      Register total{};
      for (unsigned int a = 0; a < n_nodes; ++a)
        total += rows[r][a] * weights[a];
      for (unsigned int c = 0; c < width; ++c)
        result[r * width + c] = total[c];
    }
    return result;
  }

  Register rows[n_registers][Gradients<dim>::length];
};

/// Which components of a cell the Fields are: @p first to first + Fields::n of @p n.
struct CellComponents {
  unsigned int first, n;
};

/// R_ac += sum_qJ S_q,cJ dN_a/dX_J, the weights being in S.
template <typename Fields>
void add_residual(const Gradients<Fields::dim>* gradients, const PointFluxes<Fields>* fluxes,
                  const unsigned int n_points, const CellComponents& components, double* residual)
{
  constexpr int dim = Fields::dim, n_c = Fields::n;
  const unsigned int n_nodes = gradients->n_nodes, stride = gradients->stride;
  double rows[n_c][Gradients<dim>::length] = {};
  for (unsigned int q = 0; q < n_points; ++q)
    for (int c = 0; c < n_c; ++c)
      for (int J = 0; J < Fields::n_directions; ++J)
        for (unsigned int a = 0; a < stride; ++a)
          rows[c][a] += fluxes[q / Lanes::n].S[c][J][q % Lanes::n] * gradients[q].g[J][a];
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (int c = 0; c < n_c; ++c)
      residual[a * components.n + components.first + c] += rows[c][a];
}

/// T_qJ,b = M_cJLd dN_b/dX_L + m_cJ N_b [d is theta] at the point in @p lane.
template <typename Fields>
void apply_moduli(const Gradients<Fields::dim>& gradients, const PointFluxes<Fields>& fluxes,
                  const unsigned int lane, const int c, const int d, double* T)
{
  constexpr int n_J = Fields::n_directions;
  const unsigned int stride = gradients.stride;
  double M[n_J][n_J], m[n_J] = {};
  for (int J = 0; J < n_J; ++J) {
    for (int L = 0; L < n_J; ++L)
      M[J][L] = fluxes.M[c][J][L][d][lane];
    if (Fields::has_temperature && d == Fields::n - 1)
      m[J] = fluxes.m[c][J][lane];
  }
  for (unsigned int b = 0; b < stride; b += 4) {
    Register g[n_J];
    for (int L = 0; L < n_J; ++L)
      g[L] = *reinterpret_cast<const Register*>(&gradients.g[L][b]);
    for (int J = 0; J < n_J; ++J) {
      Register sum = M[J][0] * g[0];
      for (int L = 1; L < n_J; ++L)
        sum += M[J][L] * g[L];
      if constexpr (Fields::has_temperature)
        sum += m[J] * *reinterpret_cast<const Register*>(gradients.N + b);
      *reinterpret_cast<Register*>(T + std::size_t(J) * stride + b) = sum;
    }
  }
}

/// K_ac,bd += sum_qJ dN_a/dX_J T_qJ,b, in two stages: the moduli with node b, then a product of
/// small matrices over all points at once. Without temperature the tangent is symmetric and half of
/// the components' pairs do.
template <typename Fields>
void add_tangent(const Gradients<Fields::dim>* gradients, const PointFluxes<Fields>* fluxes,
                 const unsigned int n_points, const CellComponents& components,
                 TangentBlocks& tangent)
{
  constexpr int dim = Fields::dim, n_c = Fields::n, n_J = Fields::n_directions;
  constexpr unsigned int max_rows = Basis<dim>::max_points * n_J;
  std::array<const double*, max_rows> g;
  for (unsigned int q = 0; q < n_points; ++q)
    for (int J = 0; J < n_J; ++J)
      g[q * n_J + J] = gradients[q].g[J].data();

  alignas(64) std::array<double, max_rows * Gradients<dim>::length> T;
  for (int c = 0; c < n_c; ++c)
    for (int d = Fields::has_temperature ? 0 : c; d < n_c; ++d) {
      for (unsigned int q = 0; q < n_points; ++q)
        apply_moduli(gradients[q], fluxes[q / Lanes::n], q % Lanes::n, c, d,
                     T.data() + q * n_J * gradients->stride);
      tangent.add_product(components.first + c, components.first + d, n_points * n_J, g.data(),
                          T.data());
    }
}

} // namespace thelma
