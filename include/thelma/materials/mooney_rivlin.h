#pragma once

#include <thelma/materials/shear_law.h>

namespace thelma
{

/// Compressible Mooney-Rivlin, without its volumetric energy (theory.md, eq. 8):
///   W = mu(theta)/2 ((1 - m) (I_1 - 3) + m (I_2 - 3) - 2 (1 + m) ln J),
///   W_F = mu ((1 - m) F + m (I_1 F - F C) - (1 + m) F^{-T}),
/// with the invariants I_1, I_2 of C = F^T F and the share m of the second one in the modulus.
class MooneyRivlin : public ShearLaw<MooneyRivlin>
{
public:
  static constexpr const char* name = "Mooney-Rivlin";
  static constexpr const char* meaning =
      "with a share of the second invariant, entry `Second share`";

  void declare(dealii::ParameterHandler& prm)
  {
    mu.declare(prm, "Shear modulus", "mu(theta) = 2 (C_1 + C_2).", Quantity("MPa"));
    prm.add_parameter("Second share", m,
                      "C_2/(C_1 + C_2), the share of the second invariant in the shear modulus; 0 "
                      "is neo-Hookean.",
                      dealii::Patterns::Double(0., 1.));
  }

  template <typename Number>
  Number invariant(const Tensor3<2, Number>& F, const Number& J) const
  {
    using std::log;
    const Tensor3<2, Number> C = dealii::transpose(F) * F;
    const Number I_1 = contract(F, F), I_2 = (I_1 * I_1 - contract(C, C)) / 2.;
    return (1. - m) * (I_1 - 3.) + m * (I_2 - 3.) - 2. * (1. + m) * log(J);
  }

  template <typename Number>
  Tensor3<2, Number> half_gradient(const Tensor3<2, Number>& F, const Kinematics<Number>& kin) const
  {
    const Tensor3<2, Number> FC = F * (dealii::transpose(F) * F);
    return (1. - m + m * contract(F, F)) * F - m * FC - (1. + m) * kin.G;
  }

  /// dW_iJ/dF_kL = mu ((1 - m + m I_1) d_ik d_JL + (1 + m) G_iL G_kJ
  ///   + m (2 F_iJ F_kL - F_iL F_kJ - d_ik C_JL - (F F^T)_ik d_JL)).
  template <typename Number>
  Tensor3<4, Number> second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                            const Number& theta) const
  {
    const Number modulus = mu.value(theta), diagonal = 1. - m + m * contract(F, F);
    const Tensor3<2, Number> C = dealii::transpose(F) * F, B = F * dealii::transpose(F);
    Tensor3<4, Number> W_FF;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int L = 0; L < 3; ++L) {
            Number entry = m * (2. * F[i][J] * F[k][L] - F[i][L] * F[k][J]) +
                           (1. + m) * kin.G[i][L] * kin.G[k][J];
            if (i == k)
              entry -= m * C[J][L];
            if (J == L)
              entry -= m * B[i][k];
            if (i == k && J == L)
              entry += diagonal;
            W_FF[i][J][k][L] = modulus * entry;
          }
    return W_FF;
  }

private:
  double m = 0.2;
};

} // namespace thelma
