#pragma once

#include <thelma/elements/basis.h>
#include <thelma/elements/point_system.h>

#include <array>

namespace thelma
{

/// Gradients dN_a/dX_J of all nodes at one point, [J][a].
template <int dim>
struct Gradients {
  static constexpr unsigned int max_nodes = dim == 2 ? 9 : 27;

  Gradients(const Basis<dim>& basis, const unsigned int q, const PointGeometry<dim>& point)
      : n_nodes(basis.n_nodes), N(basis.N.data() + q * basis.n_nodes)
  {
    const double* reference = basis.dN.data() + q * dim * n_nodes;
    for (int J = 0; J < dim; ++J)
      for (unsigned int a = 0; a < n_nodes; ++a) {
        double sum = 0.;
        for (int K = 0; K < dim; ++K)
          sum += point.inverse_jacobian[K][J] * reference[K * n_nodes + a];
        g[J][a] = sum;
      }
  }

  /// Gradient of each component and the value of the last one, from nodal values [a][c].
  template <int n_c>
  double interpolate(const double* x, double (&gradient)[n_c][dim]) const
  {
    double last = 0.;
    for (auto& row : gradient)
      for (double& entry : row)
        entry = 0.;
    for (unsigned int a = 0; a < n_nodes; ++a) {
      for (int c = 0; c < n_c; ++c)
        for (int J = 0; J < dim; ++J)
          gradient[c][J] += x[a * n_c + c] * g[J][a];
      last += x[a * n_c + n_c - 1] * N[a];
    }
    return last;
  }

  unsigned int n_nodes;
  const double* N;
  std::array<std::array<double, max_nodes>, dim> g;
};

/// R_ac += w S_cJ dN_a/dX_J.
template <typename Fields>
void add_residual(const Gradients<Fields::dim>& gradients, const PointSystem<Fields>& system,
                  const double w, double* residual)
{
  constexpr int dim = Fields::dim, n_c = Fields::n;
  for (unsigned int a = 0; a < gradients.n_nodes; ++a)
    for (int c = 0; c < n_c; ++c)
      for (int J = 0; J < dim; ++J)
        residual[a * n_c + c] += w * system.S[c][J] * gradients.g[J][a];
}

/// K_ac,bd += w dN_a/dX_J (M_cJLd dN_b/dX_L + m_cJ N_b [d is theta]), in two stages: first the
/// moduli with node b, then with node a. Without temperature the tangent is symmetric and only the
/// blocks a <= b are filled.
template <typename Fields>
void add_tangent(const Gradients<Fields::dim>& gradients, const PointSystem<Fields>& system,
                 const double w, double* tangent)
{
  constexpr int dim = Fields::dim, n_c = Fields::n;
  const unsigned int n_nodes = gradients.n_nodes, width = n_nodes * n_c;
  for (unsigned int b = 0; b < n_nodes; ++b) {
    double T[n_c][dim][n_c];
    for (int c = 0; c < n_c; ++c)
      for (int J = 0; J < dim; ++J) {
        for (int d = 0; d < n_c; ++d) {
          double sum = 0.;
          for (int L = 0; L < dim; ++L)
            sum += system.M[c][J][L][d] * gradients.g[L][b];
          T[c][J][d] = w * sum;
        }
        if constexpr (Fields::has_temperature)
          T[c][J][n_c - 1] += w * system.m[c][J] * gradients.N[b];
      }
    const unsigned int end = Fields::has_temperature ? n_nodes : b + 1;
    for (unsigned int a = 0; a < end; ++a)
      for (int c = 0; c < n_c; ++c) {
        double* row = tangent + (a * n_c + c) * width + b * n_c;
        for (int d = 0; d < n_c; ++d) {
          double sum = row[d];
          for (int J = 0; J < dim; ++J)
            sum += gradients.g[J][a] * T[c][J][d];
          row[d] = sum;
        }
      }
  }
}

/// Fill the blocks a > b of a symmetric tangent from those with a < b.
inline void mirror(const unsigned int width, double* tangent)
{
  for (unsigned int i = 0; i < width; ++i)
    for (unsigned int j = 0; j < i; ++j)
      tangent[i * width + j] = tangent[j * width + i];
}

} // namespace thelma
