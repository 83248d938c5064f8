#pragma once

#include <thelma/base/jet.h>
#include <thelma/materials/point.h>

#include <array>

namespace thelma
{

/// I_1 and I_2 of C = F^T F and J = det F, and how a function w of them (variables 0, 1, 2 of a
/// jet) depends on F: w_F is the sum of w_a da, w_FF that of w_ab da x db and w_a d^2a.
template <typename Number>
class Invariants
{
public:
  Invariants(const Tensor3<2, Number>& F, const Number& J)
      : J(J), C(dealii::transpose(F) * F), I_1(contract(F, F)),
        I_2((I_1 * I_1 - contract(C, C)) / 2.)
  {
  }

  /// dI_1 = 2 F, dI_2 = 2 (I_1 F - F C), dJ = J F^{-T}.
  std::array<Tensor3<2, Number>, 3> gradients(const Tensor3<2, Number>& F,
                                              const Tensor3<2, Number>& G) const
  {
    return {{2. * F, 2. * (I_1 * F - F * C), J * G}};
  }

  /// w_FF, of which with B = F F^T
  ///   d^2 I_1 = 2 d_ik d_JL,   d^2 J = J (G_iJ G_kL - G_iL G_kJ),
  ///   d^2 I_2 = 2 (I_1 d_ik d_JL + 2 F_iJ F_kL - F_iL F_kJ - d_ik C_JL - B_ik d_JL).
  template <std::size_t n>
  Tensor3<4, Number> second(const Jet<Number, n>& w, const Tensor3<2, Number>& F,
                            const Tensor3<2, Number>& G) const
  {
    const auto gradient = gradients(F, G);
    const Number w_2 = 2. * w.first[1], w_J = J * w.first[2],
                 diagonal = 2. * w.first[0] + w_2 * I_1;
    const Tensor3<2, Number> B = F * dealii::transpose(F);
    std::array<Tensor3<2, Number>, 3> sum; // w_ab db
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        sum[a] += w.seconds[w.second(a, b)] * gradient[b];
    Tensor3<4, Number> w_FF;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int L = 0; L < 3; ++L) {
            Number entry = w_2 * (2. * F[i][J] * F[k][L] - F[i][L] * F[k][J]) +
                           w_J * (G[i][J] * G[k][L] - G[i][L] * G[k][J]);
            for (unsigned int a = 0; a < 3; ++a)
              entry += gradient[a][i][J] * sum[a][k][L];
            if (i == k)
              entry -= w_2 * C[J][L];
            if (J == L)
              entry -= w_2 * B[i][k];
            if (i == k && J == L)
              entry += diagonal;
            w_FF[i][J][k][L] = entry;
          }
    return w_FF;
  }

  const Number J;
  const Tensor3<2, Number> C;
  const Number I_1, I_2;
};

} // namespace thelma
