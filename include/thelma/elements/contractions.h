#pragma once

#include <thelma/elements/basis.h>
#include <thelma/elements/point_system.h>

#include <array>
#include <cstring>

/// The hot loops of assembly. Rows over nodes are padded to whole vector registers.
namespace thelma
{

/// Gradients dN_a/dX_J of all nodes at one point, [J][a].
template <int dim>
struct Gradients {
  static constexpr unsigned int length = padded(Basis<dim>::max_nodes);

  Gradients() = default;
  Gradients(const Basis<dim>& basis, const unsigned int q, const PointGeometry<dim>& point)
      : n_nodes(basis.n_nodes), stride(basis.stride), N(basis.N.data() + q * stride)
  {
    const double* reference = basis.dN.data() + q * dim * stride;
    for (int J = 0; J < dim; ++J)
      for (unsigned int a = 0; a < stride; ++a) {
        double sum = 0.;
        for (int K = 0; K < dim; ++K)
          sum += point.inverse_jacobian[K][J] * reference[K * stride + a];
        g[J][a] = sum;
      }
  }

  unsigned int n_nodes, stride;
  const double* N;
  std::array<std::array<double, length>, dim> g;
};

/// Nodal values of one cell by components, [c][a].
template <int dim>
struct NodalValues {
  NodalValues(const double* x, const unsigned int n_nodes, const unsigned int n_c)
      : n_components(n_c)
  {
    for (unsigned int c = 0; c < n_c; ++c) {
      for (unsigned int a = 0; a < n_nodes; ++a)
        rows[c][a] = x[a * n_c + c];
      for (unsigned int a = n_nodes; a < padded(n_nodes); ++a)
        rows[c][a] = 0.;
    }
  }

  double gradient(const unsigned int c, const int J, const Gradients<dim>& gradients) const
  {
    return product(rows[c].data(), gradients.g[J].data(), gradients.stride);
  }

  double value(const unsigned int c, const Gradients<dim>& gradients) const
  {
    return product(rows[c].data(), gradients.N, gradients.stride);
  }

  unsigned int n_components;

private:
  static double product(const double* x, const double* y, const unsigned int n)
  {
    double lanes[4] = {0., 0., 0., 0.};
    for (unsigned int a = 0; a < n; a += 4)
      for (int l = 0; l < 4; ++l)
        lanes[l] += x[a + l] * y[a + l];
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
  }

  std::array<std::array<double, Gradients<dim>::length>, dim + 2> rows;
};

/// Four doubles in one register, wherever they lie.
using Lanes = double __attribute__((vector_size(32), aligned(8), may_alias));

/// C_ab = sum_k A_ka B_kb for rows A_k of any place and a dense B with rows of 4 * width; two rows
/// of C at a time stay in registers.
template <int width>
void multiply(const unsigned int n_k, const double* const* A, const double* B,
              const unsigned int n_rows, double* C)
{
  for (unsigned int a = 0; a < n_rows; a += 2) {
    Lanes first[width] = {}, second[width] = {};
    for (unsigned int k = 0; k < n_k; ++k) {
      const Lanes* b = reinterpret_cast<const Lanes*>(B + k * 4 * width);
      const double x = A[k][a], y = A[k][a + 1];
      for (int v = 0; v < width; ++v) {
        first[v] += x * b[v];
        second[v] += y * b[v];
      }
    }
    std::memcpy(C + a * 4 * width, first, sizeof(first));
    std::memcpy(C + (a + 1) * 4 * width, second, sizeof(second));
  }
}

/// The same for rows of B and C of length @p stride; A and C have room for an even number of rows.
inline void multiply(const unsigned int stride, const unsigned int n_k, const double* const* A,
                     const double* B, const unsigned int n_rows, double* C)
{
  switch (stride) {
  case 4:
    return multiply<1>(n_k, A, B, n_rows, C);
  case 8:
    return multiply<2>(n_k, A, B, n_rows, C);
  case 12:
    return multiply<3>(n_k, A, B, n_rows, C);
  default:
    return multiply<7>(n_k, A, B, n_rows, C);
  }
}

/// Add the block C_ab of the components c, d to the tangent of a cell with n_c components; with
/// @p mirrored its transpose to the block d, c.
inline void add_block(const double* C, const unsigned int n_nodes, const unsigned int n_c,
                      const unsigned int c, const unsigned int d, const bool mirrored,
                      double* tangent)
{
  const std::size_t n = n_nodes * n_c, stride = padded(n_nodes);
  for (unsigned int a = 0; a < n_nodes; ++a) {
    double* row = tangent + (a * n_c + c) * n + d;
    double* column = tangent + d * n + a * n_c + c;
    for (unsigned int b = 0; b < n_nodes; ++b) {
      row[b * n_c] += C[a * stride + b];
      if (mirrored)
        column[b * n_c * n] += C[a * stride + b];
    }
  }
}

/// Which components of a cell the Fields are: @p first to first + Fields::n of @p n.
struct CellComponents {
  unsigned int first, n;
};

/// R_ac += sum_qJ S_q,cJ dN_a/dX_J, the weights being in S.
template <typename Fields>
void add_residual(const Gradients<Fields::dim>* gradients, const PointSystem<Fields>* systems,
                  const unsigned int n_points, const CellComponents& components, double* residual)
{
  constexpr int dim = Fields::dim, n_c = Fields::n;
  const unsigned int n_nodes = gradients->n_nodes, stride = gradients->stride;
  double rows[n_c][Gradients<dim>::length] = {};
  for (unsigned int q = 0; q < n_points; ++q)
    for (int c = 0; c < n_c; ++c)
      for (int J = 0; J < dim; ++J)
        for (unsigned int a = 0; a < stride; ++a)
          rows[c][a] += systems[q].S[c][J] * gradients[q].g[J][a];
  for (unsigned int a = 0; a < n_nodes; ++a)
    for (int c = 0; c < n_c; ++c)
      residual[a * components.n + components.first + c] += rows[c][a];
}

/// K_ac,bd += sum_qJ dN_a/dX_J (M_cJLd dN_b/dX_L + m_cJ N_b [d is theta]), in two stages: the
/// moduli with node b, then a product of small matrices over all points at once. Without
/// temperature the tangent is symmetric and half of the components' pairs do.
template <typename Fields>
void add_tangent(const Gradients<Fields::dim>* gradients, const PointSystem<Fields>* systems,
                 const unsigned int n_points, const CellComponents& components, double* tangent)
{
  constexpr int dim = Fields::dim, n_c = Fields::n;
  constexpr unsigned int max_rows = Basis<dim>::max_points * dim, length = Gradients<dim>::length;
  const unsigned int n_nodes = gradients->n_nodes, stride = gradients->stride;
  std::array<const double*, max_rows> g;
  for (unsigned int q = 0; q < n_points; ++q)
    for (int J = 0; J < dim; ++J)
      g[q * dim + J] = gradients[q].g[J].data();

  alignas(32) std::array<double, max_rows * length> T;
  alignas(32) std::array<double, length * length> C;
  for (int c = 0; c < n_c; ++c)
    for (int d = Fields::has_temperature ? 0 : c; d < n_c; ++d) {
      for (unsigned int q = 0; q < n_points; ++q)
        for (int J = 0; J < dim; ++J) {
          double* row = T.data() + (q * dim + J) * stride;
          for (unsigned int b = 0; b < stride; ++b) {
            double sum = 0.;
            for (int L = 0; L < dim; ++L)
              sum += systems[q].M[c][J][L][d] * gradients[q].g[L][b];
            row[b] = sum;
          }
          if constexpr (Fields::has_temperature)
            if (d == n_c - 1)
              for (unsigned int b = 0; b < stride; ++b)
                row[b] += systems[q].m[c][J] * gradients[q].N[b];
        }
      multiply(stride, n_points * dim, g.data(), T.data(), n_nodes, C.data());
      add_block(C.data(), n_nodes, components.n, components.first + c, components.first + d,
                !Fields::has_temperature && c != d, tangent);
    }
}

} // namespace thelma
