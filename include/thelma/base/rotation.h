#pragma once

#include <deal.II/base/tensor.h>

namespace thelma
{

/// F = R U with a rotation R and a symmetric positive definite U.
struct PolarDecomposition {
  explicit PolarDecomposition(const dealii::Tensor<2, 3>& F);

  dealii::Tensor<2, 3> R, U;
};

/// Axis times angle (rad, at most pi) of the rotation @p R.
dealii::Tensor<1, 3> rotation_vector(const dealii::Tensor<2, 3>& R);

/// The rotation vector of @p R that comes nearest to @p expected, by more than half a turn if need
/// be.
dealii::Tensor<1, 3> rotation_near(const dealii::Tensor<2, 3>& R,
                                   const dealii::Tensor<1, 3>& expected);

/// The rotation with this rotation vector.
dealii::Tensor<2, 3> rotation(const dealii::Tensor<1, 3>& vector);

} // namespace thelma
