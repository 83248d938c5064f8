#pragma once

#include <thelma/materials/shear_law.h>

namespace thelma
{

/// Gent's rubber with chains of finite length (theory.md, eq. 6), without its volumetric energy:
///   W = -mu(theta)/2 (J_m ln(1 - (F : F - 3)/J_m) + 2 ln J),   W_F = mu (a F - F^{-T}),
///   a = J_m/(J_m - F : F + 3).
/// It stiffens beyond all bounds as F : F - 3 approaches J_m and is neo-Hookean as J_m grows.
class Gent : public ShearLaw<Gent>
{
public:
  static constexpr const char* name = "Gent";
  static constexpr const char* meaning =
      "neo-Hookean with finite chain extensibility, entry `Gent limit`";

  void declare(dealii::ParameterHandler& prm)
  {
    mu.declare(prm, "Shear modulus", "mu(theta).", Quantity("MPa"));
    prm.add_parameter("Gent limit", J_m,
                      "J_m, the value of tr C_EM - 3 at which the chains are fully extended.",
                      dealii::Patterns::Double(1e-12));
  }

  template <typename Number>
  Number invariant(const Tensor3<2, Number>& F, const Number& J) const
  {
    using std::log;
    return J_m * log(stiffening(F)) - 2. * log(J);
  }

  template <typename Number>
  Tensor3<2, Number> half_gradient(const Tensor3<2, Number>& F, const Kinematics<Number>& kin) const
  {
    return stiffening(F) * F - kin.G;
  }

  /// dW_iJ/dF_kL = mu (a d_ik d_JL + 2 a^2/J_m F_iJ F_kL + G_iL G_kJ).
  template <typename Number>
  Tensor3<4, Number> second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                            const Number& theta) const
  {
    const Number modulus = mu.value(theta), a = stiffening(F), slope = 2. * a * a / J_m;
    Tensor3<4, Number> W_FF;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J) {
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int L = 0; L < 3; ++L)
            W_FF[i][J][k][L] = modulus * (slope * F[i][J] * F[k][L] + kin.G[i][L] * kin.G[k][J]);
        W_FF[i][J][i][J] += modulus * a;
      }
    return W_FF;
  }

private:
  /// a; no number beyond J_m, where there is no state.
  template <typename Number>
  Number stiffening(const Tensor3<2, Number>& F) const
  {
    const Number left = J_m - contract(F, F) + 3.;
    return J_m / positive(left);
  }

  double J_m = 100.;
};

} // namespace thelma
