#pragma once

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

namespace thelma
{

/// What a mesh of two dimensions is a section through: a body in plane strain, or half a section
/// through a body of revolution about x_1 = 0. In space nothing.
template <int dim>
class CrossSection
{
public:
  void declare(dealii::ParameterHandler& prm);

  bool is_axisymmetric() const { return geometry == Geometry::axisymmetric; }

  /// What a point of the section stands for across it: in a body of revolution, the length of the
  /// circle around the axis in mm; otherwise 1.
  double depth(const dealii::Point<dim>& x) const
  {
    return is_axisymmetric() ? 2. * dealii::numbers::PI * x[0] : 1.;
  }

  /// The curvature 1/x_1 of this circle in 1/mm; otherwise 0.
  double curvature(const dealii::Point<dim>& x) const { return is_axisymmetric() ? 1. / x[0] : 0.; }

  /// Directions along which forces, areas and volumes count: without that across plane strain.
  int n_sizes() const { return is_axisymmetric() ? 3 : dim; }

private:
  enum class Geometry { plane_strain, axisymmetric };
  Geometry geometry = Geometry::plane_strain;
};

} // namespace thelma
