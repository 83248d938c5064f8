#pragma once

#include <thelma/fields/dof_layout.h>

#include <deal.II/base/quadrature.h>

#include <vector>

namespace thelma
{

/// Rows of nodal quantities are padded with zeros to whole vector registers.
constexpr unsigned int padded(const unsigned int n_nodes)
{
  return (n_nodes + 3) / 4 * 4;
}

/// Shape functions of the scalar element on the reference cell at the points of one rule.
template <int dim>
struct Basis {
  static constexpr unsigned int max_nodes = dim == 2 ? 9 : 27, max_points = max_nodes;

  /// @p n_enhanced more modes, zero here, follow the nodes'.
  Basis(const dealii::FiniteElement<dim>& scalar, const dealii::Quadrature<dim>& rule,
        unsigned int n_enhanced = 0);

  unsigned int n_points, n_nodes, stride; ///< stride = padded(n_nodes)
  std::vector<double> N;                  ///< [q][a], rows of length stride
  std::vector<double> dN;                 ///< [q][direction][a], rows of length stride
};

/// Map from the reference cell at one quadrature point, in the undeformed body.
template <int dim>
struct PointGeometry {
  dealii::Tensor<2, dim> inverse_jacobian; ///< [reference direction][X direction]
  double JxW;                              ///< mm^dim, of a body of revolution mm^3
  double curvature = 0.; ///< 1/R of the circle around the axis of a body of revolution, 1/mm
};

/// The quadrature points of every own cell; nothing here changes while the body deforms.
template <int dim>
class Integration
{
public:
  /// @p n_points Gauss points per direction.
  Integration(const DofLayout<dim>& layout, unsigned int n_points, unsigned int n_enhanced = 0);

  const Basis<dim>& basis() const { return shape; }
  const PointGeometry<dim>* of_cell(const std::size_t cell) const
  {
    return geometry.data() + cell * shape.n_points;
  }
  const dealii::Quadrature<dim>& quadrature() const { return rule; }

private:
  dealii::Quadrature<dim> rule;
  Basis<dim> shape;
  std::vector<PointGeometry<dim>> geometry;
};

} // namespace thelma
