#pragma once

#include <thelma/materials/shear_law.h>

namespace thelma
{

/// Compressible neo-Hookean, without its volumetric energy (theory.md, eq. 5):
///   W = mu(theta)/2 (F : F - 3 - 2 ln J),   W_F = mu (F - F^{-T}).
/// The modulus is a TemperatureLaw in MPa.
class NeoHookean : public ShearLaw<NeoHookean>
{
public:
  static constexpr const char* name = "neo-Hookean";
  static constexpr const char* meaning = "W = mu/2 (I_1 - 3 - 2 ln J)";

  void declare(dealii::ParameterHandler& prm)
  {
    mu.declare(prm, "Shear modulus", "mu(theta).", Quantity("MPa"));
  }

  template <typename Number>
  Number invariant(const Tensor3<2, Number>& F, const Number& J) const
  {
    using std::log;
    return contract(F, F) - 3. - 2. * log(J);
  }

  template <typename Number>
  Tensor3<2, Number> half_gradient(const Tensor3<2, Number>& F, const Kinematics<Number>& kin) const
  {
    return F - kin.G;
  }

  /// W_FF = mu (I + F^{-T} x F^{-T}), dW_iJ/dF_kL = mu (d_ik d_JL + G_iL G_kJ).
  template <typename Number>
  Tensor3<4, Number> second(const Tensor3<2, Number>&, const Kinematics<Number>& kin,
                            const Number& theta) const
  {
    const Number modulus = mu.value(theta);
    Tensor3<4, Number> W_FF;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J) {
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int L = 0; L < 3; ++L)
            W_FF[i][J][k][L] = modulus * kin.G[i][L] * kin.G[k][J];
        W_FF[i][J][i][J] += modulus;
      }
    return W_FF;
  }
};

} // namespace thelma
