#pragma once

#include <thelma/materials/shear_law.h>

#include <vector>

namespace thelma
{

/// Yeoh's polynomial in x = F : F - 3 (theory.md, eq. 9), without its volumetric energy:
///   W = mu(theta)/2 (p(x) - 2 ln J),   p = x + c_2 x^2 + c_3 x^3 + ...,   c_i = C_i/C_1,
///   W_F = mu (p' F - F^{-T}).
class Yeoh : public ShearLaw<Yeoh>
{
public:
  static constexpr const char* name = "Yeoh";
  static constexpr const char* meaning = "polynomial in I_1 - 3, entry `Yeoh ratios`";

  void declare(dealii::ParameterHandler& prm)
  {
    mu.declare(prm, "Shear modulus", "mu(theta) = 2 C_1.", Quantity("MPa"));
    add_quantity(prm, "Yeoh ratios", ratios,
                 "C_2/C_1, C_3/C_1, ... of the powers of tr C_EM - 3 in W. Default: the Taylor "
                 "series of the law Arruda-Boyce with its default lambda_L.",
                 Quantity("1"));
  }

  template <typename Number>
  Number invariant(const Tensor3<2, Number>& F, const Number& J) const
  {
    using std::log;
    return Polynomial<Number>(F, ratios).value - 2. * log(J);
  }

  template <typename Number>
  Tensor3<2, Number> half_gradient(const Tensor3<2, Number>& F, const Kinematics<Number>& kin) const
  {
    return Polynomial<Number>(F, ratios).slope * F - kin.G;
  }

  /// dW_iJ/dF_kL = mu (p' d_ik d_JL + 2 p'' F_iJ F_kL + G_iL G_kJ).
  template <typename Number>
  Tensor3<4, Number> second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                            const Number& theta) const
  {
    const Polynomial<Number> p(F, ratios);
    const Number modulus = mu.value(theta), diagonal = modulus * p.slope,
                 curvature = 2. * modulus * p.curvature;
    Tensor3<4, Number> W_FF;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J) {
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int L = 0; L < 3; ++L)
            W_FF[i][J][k][L] = curvature * F[i][J] * F[k][L] + modulus * kin.G[i][L] * kin.G[k][J];
        W_FF[i][J][i][J] += diagonal;
      }
    return W_FF;
  }

private:
  /// p and its derivatives at an F (Horner).
  template <typename Number>
  struct Polynomial {
    Polynomial(const Tensor3<2, Number>& F, const std::vector<double>& ratios)
    {
      const Number x = contract(F, F) - 3.;
      for (auto c = ratios.rbegin(); c != ratios.rend(); ++c)
        add(x, *c);
      add(x, 1.);
      add(x, 0.);
    }

    void add(const Number& x, const double coefficient)
    {
      curvature = curvature * x + 2. * slope;
      slope = slope * x + value;
      value = value * x + coefficient;
    }

    Number value = 0., slope = 0., curvature = 0.;
  };

  std::vector<double> ratios{2.89e-3, 1.75e-5};
};

} // namespace thelma
