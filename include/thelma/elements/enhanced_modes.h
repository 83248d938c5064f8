#pragma once

#include <thelma/elements/cell_points.h>

#include <vector>

namespace thelma
{

/// The modes M_k of enhanced strain and field (theory.md, eq. 31): dim quadratic bubbles across
/// each cell, of which only the gradients at the Gauss points of a linear element matter. An
/// amplitude alpha_k has the components of a node; they are stored [k][c].
template <int dim>
class EnhancedModes
{
public:
  static constexpr unsigned int n_nodes = 1u << dim, n_points = n_nodes; ///< of a linear element

  explicit EnhancedModes(const DofLayout<dim>& layout);

  /// Put the gradients at point @p q after those of the nodes.
  void set_gradients(const std::size_t cell, const unsigned int q, Gradients<dim>& gradients) const
  {
    for (int J = 0; J < dim; ++J)
      for (int k = 0; k < dim; ++k)
        gradients.g[J][n_nodes + k] = slopes[cell * n_points + q][J][k];
  }

  /// int |Grad M_k|^2 dV, as if all points had the same share of the volume.
  double squared_norm(std::size_t cell, int k) const;

  /// Make the displacements in @p alpha those of an observer who deforms with the centre of the
  /// cell; and the way back.
  void pull_back(const CellView<dim>& view, double* alpha) const;
  void push_forward(const CellView<dim>& view, double* alpha) const;

private:
  using Slopes = std::array<std::array<double, dim>, dim>; ///< dM_k/dX_J, [J][k]

  void add_slopes(const PointGeometry<dim>& centre, const dealii::Quadrature<dim>& rule,
                  const PointGeometry<dim>* points);
  dealii::Tensor<2, dim> centre_gradient(const CellView<dim>& view) const;

  Integration<dim> centre;
  std::vector<Slopes> slopes; ///< at the points of every cell
};

} // namespace thelma
