// Polar decomposition and rotation vectors against their definitions.

#include <thelma/base/rotation.h>

#include <gtest/gtest.h>

namespace
{

using namespace thelma;

TEST(Rotation, VectorAndMatrixAreInverse)
{
  const dealii::Tensor<1, 3> vector({0.3, -1.1, 2.0});
  const dealii::Tensor<2, 3> R = rotation(vector);
  EXPECT_NEAR(dealii::determinant(R), 1., 1e-14);
  EXPECT_LT((rotation_vector(R) - vector).norm(), 1e-13);
  EXPECT_EQ(rotation_vector(rotation(dealii::Tensor<1, 3>())).norm(), 0.);
}

TEST(Rotation, PolarDecompositionIsThatOfItsFactors)
{
  const dealii::Tensor<2, 3> R = rotation(dealii::Tensor<1, 3>({2., 1., -0.5}));
  const dealii::Tensor<2, 3> U({{1.4, 0.2, 0.1}, {0.2, 0.8, -0.1}, {0.1, -0.1, 1.}});
  const PolarDecomposition polar(R * U);
  EXPECT_LT((polar.R - R).norm(), 1e-12);
  EXPECT_LT((polar.U - U).norm(), 1e-12);
}

} // namespace
