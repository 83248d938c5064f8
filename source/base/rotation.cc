#include <thelma/base/rotation.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>
#include <deal.II/physics/elasticity/standard_tensors.h>
#include <deal.II/physics/transformations.h>

#include <cmath>

namespace thelma
{

PolarDecomposition::PolarDecomposition(const dealii::Tensor<2, 3>& F) : R(F)
{
  // Newton's method for the orthogonal factor (Higham 1986); quadratic from any F with det F > 0.
  constexpr double tolerance = 1e-12;
  for (int i = 0; i < 30; ++i) {
    const dealii::Tensor<2, 3> next = 0.5 * (R + dealii::transpose(dealii::invert(R)));
    const double change = (next - R).norm();
    R = next;
    if (change < tolerance)
      break;
  }
  U = dealii::transpose(R) * F;
}

dealii::Tensor<1, 3> rotation_vector(const dealii::Tensor<2, 3>& R)
{
  dealii::Tensor<1, 3> axis; // times 2 sin(angle)
  for (int i = 0; i < 3; ++i)
    axis[i] = R[(i + 2) % 3][(i + 1) % 3] - R[(i + 1) % 3][(i + 2) % 3];
  const double sine = axis.norm() / 2., cosine = (dealii::trace(R) - 1.) / 2.;
  return sine > 0. ? std::atan2(sine, cosine) / (2. * sine) * axis : axis;
}

dealii::Tensor<1, 3> rotation_near(const dealii::Tensor<2, 3>& R,
                                   const dealii::Tensor<1, 3>& expected)
{
  const dealii::Tensor<1, 3> turn = rotation_vector(R);
  const double angle = turn.norm();
  if (angle == 0.)
    return turn;
  const double whole = 2. * dealii::numbers::PI;
  return turn + std::round((expected - turn) * turn / (angle * whole)) * whole / angle * turn;
}

dealii::Tensor<2, 3> rotation(const dealii::Tensor<1, 3>& vector)
{
  const double angle = vector.norm();
  if (angle == 0.)
    return dealii::Physics::Elasticity::StandardTensors<3>::I;
  return dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
      dealii::Point<3>(vector / angle), angle);
}

} // namespace thelma
