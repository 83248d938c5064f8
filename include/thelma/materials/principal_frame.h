#pragma once

#include <thelma/materials/point.h>

#include <cmath>
#include <type_traits>

namespace thelma
{

/// The rotation V that makes the columns of F V orthogonal: principal directions of C. One-sided
/// Jacobi rotations without branches, so that small stretches are as exact as large ones and equal
/// ones no exception; four sweeps reach rounding, the fifth is for what is worse than random F.
template <typename Number>
Tensor3<2, Number> principal_directions(Tensor3<2, Number> F)
{
  using std::sqrt;
  constexpr unsigned int n_sweeps = 5, pairs[][2] = {{0, 1}, {0, 2}, {1, 2}};
  constexpr double tiny = 1e-300; // no angle where the columns are orthogonal and as long
  Tensor3<2, Number> V;
  for (unsigned int i = 0; i < 3; ++i)
    V[i][i] = 1.;
  for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
    for (const auto& [a, b] : pairs) {
      Number difference = 0., product = 0.;
      for (unsigned int i = 0; i < 3; ++i) {
        difference += (F[i][b] - F[i][a]) * (F[i][b] + F[i][a]);
        product += 2. * F[i][a] * F[i][b];
      }
      const Number size = sqrt(Number(difference * difference + product * product + tiny)),
                   tan = product / (difference + below(difference, 0., Number(-size), size)),
                   cos = 1. / sqrt(Number(1. + tan * tan)), sin = cos * tan;
      for (Tensor3<2, Number>* columns : {&F, &V})
        for (unsigned int i = 0; i < 3; ++i) {
          Number &x = (*columns)[i][a], &y = (*columns)[i][b];
          const Number old = x;
          x = cos * old - sin * y;
          y = sin * old + cos * y;
        }
    }
  return V;
}

/// Numbers that carry derivatives.
template <typename Number>
constexpr bool is_automatic = !std::is_same<Number, Given<Number>>::value;

/// F in its principal directions. These are given numbers even where F has derivatives: C in their
/// frame then has derivatives beside its diagonal, which are exact for equal stretches as well.
template <typename Number>
struct PrincipalFrame {
  explicit PrincipalFrame(const Tensor3<2, Number>& F)
      : V(principal_directions(values(F))), FV(F * V)
  {
    using std::log;
    for (unsigned int a = 0; a < 3; ++a) {
      square[a] = C(a, a);
      log_stretch[a] = log(square[a]) / 2.;
    }
  }

  /// Of V^T C V; beside the diagonal no more than derivatives.
  Number C(const unsigned int a, const unsigned int b) const
  {
    return FV[0][a] * FV[0][b] + FV[1][a] * FV[1][b] + FV[2][a] * FV[2][b];
  }

  Tensor3<2, Number> V, FV;
  Tensor3<1, Number> square, log_stretch;

private:
  static Tensor3<2, Given<Number>> values(const Tensor3<2, Number>& F)
  {
    if constexpr (is_automatic<Number>) {
      Tensor3<2> result;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J)
          result[i][J] = F[i][J].val();
      return result;
    } else
      return F;
  }
};

} // namespace thelma
