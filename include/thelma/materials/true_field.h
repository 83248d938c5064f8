#pragma once

#include <thelma/materials/point.h>

namespace thelma
{

/// The electric field in the deformed body, g = F^{-T} E, and d = F^{-1} g.
template <typename Number>
struct TrueField {
  TrueField(const PointState<Number>& state, const Kinematics<Number>& kin)
      : g(kin.G * state.E), d(g * kin.G), square(g * g)
  {
  }

  Tensor3<1, Number> g, d;
  Number square; ///< g.g
};

/// Add what @p of_gd g x d - @p of_G G is to @p out.
template <typename Number>
void add_stress(const TrueField<Number>& field, const Kinematics<Number>& kin, const Number& of_gd,
                const Number& of_G, Tensor3<2, Number>& out)
{
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int J = 0; J < 3; ++J)
      out[i][J] += of_gd * field.g[i] * field.d[J] - of_G * kin.G[i][J];
}

/// Add the derivatives of psi = -J Phi(g.g) with respect to F and E, given J Phi and J e, where
/// e = 2 dPhi/d(g.g) (theory.md, eq. 20): P = J (e g x d - Phi G), D = J e d.
template <typename Number>
void add_maxwell(const TrueField<Number>& field, const Kinematics<Number>& kin, const Number& e_J,
                 const Number& Phi_J, FirstDerivatives<Number>& out)
{
  add_stress(field, kin, e_J, Phi_J, out.P);
  out.D += e_J * field.d;
}

/// Likewise the second ones at fixed e.
template <typename Number>
void add_maxwell(const TrueField<Number>& field, const Kinematics<Number>& kin, const Number& e_J,
                 const Number& Phi_J, SecondDerivatives<Number>& out)
{
  const Tensor3<2, Number>& G = kin.G;
  const Tensor3<1, Number>&g = field.g, &d = field.d;
  const Tensor3<2, Number> C_inv = dealii::transpose(G) * G;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int J = 0; J < 3; ++J) {
      const Number stress = e_J * g[i] * d[J] - Phi_J * G[i][J];
      out.dD_dE[i][J] += e_J * C_inv[i][J];
      for (unsigned int L = 0; L < 3; ++L) {
        const Number of_field = e_J * (G[i][L] * d[J] + g[i] * C_inv[J][L] - d[L] * G[i][J]),
                     across = Phi_J * G[i][L] - e_J * g[i] * d[L];
        out.dP_dE[i][J][L] += of_field;
        for (unsigned int k = 0; k < 3; ++k)
          out.dP_dF[i][J][k][L] += G[k][L] * stress + G[k][J] * across - g[k] * of_field;
      }
    }
}

} // namespace thelma
