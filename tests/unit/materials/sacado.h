#pragma once

#include <thelma/materials/point.h>
#include <thelma/materials/sacado_tensors.h>

/// Sacado as the oracle of the point physics.
namespace thelma::material_tests
{

/// The independent variables of a point, in this order: F row by row, E, theta.
using Ad = Sacado::Fad::SFad<double, 13>;

inline PointState<Ad> seeded(const PointState<>& state)
{
  PointState<Ad> ad;
  for (int i = 0; i < 3; ++i) {
    for (int J = 0; J < 3; ++J)
      ad.F[i][J] = Ad(13, 3 * i + J, state.F[i][J]);
    ad.E[i] = Ad(13, 9 + i, state.E[i]);
  }
  ad.theta = Ad(13, 12, state.theta);
  ad.history = state.history;
  return ad;
}

inline Tensor3<2> d_dF(const Ad& f)
{
  Tensor3<2> result;
  for (int i = 0; i < 3; ++i)
    for (int J = 0; J < 3; ++J)
      result[i][J] = f.dx(3 * i + J);
  return result;
}

inline Tensor3<1> d_dE(const Ad& f)
{
  Tensor3<1> result;
  for (int J = 0; J < 3; ++J)
    result[J] = f.dx(9 + J);
  return result;
}

inline double d_dtheta(const Ad& f)
{
  return f.dx(12);
}

/// P, D and eta as the derivatives of the energy @p psi.
inline FirstDerivatives<> derivatives_of_energy(const Ad& psi)
{
  return {d_dF(psi), -d_dE(psi), -d_dtheta(psi)};
}

} // namespace thelma::material_tests
