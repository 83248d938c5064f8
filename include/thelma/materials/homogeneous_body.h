#pragma once

#include <thelma/materials/material_test.h>

namespace thelma
{

/// The balance of a homogeneous body in a MaterialTest: its free stretches are such that there is
/// no stress along them.
class HomogeneousBody
{
public:
  HomogeneousBody(const Material& material, MaterialTest::Mode mode);

  /// Find the state that what is @p imposed leads to from the last one, with this history. Whether
  /// there is one, and stable; if not, the last one is kept.
  bool find_balance(const Imposed& imposed, const double* step);

  /// Of the last state.
  double stress() const { return P[0][0]; }
  const PointState<>& state() const { return last; }

private:
  static constexpr unsigned int max_free = 2;

  /// Stress, and how the stresses along the free axes change with the logarithms of the free
  /// stretches.
  void evaluate(const PointState<>& at);

  const Material* material;
  MaterialTest::Mode mode;
  unsigned int first_free, n_free; ///< axes
  PointState<> last;
  Tensor3<2> P;
  dealii::Tensor<1, max_free> force;
  dealii::Tensor<2, max_free> stiffness;
};

} // namespace thelma
