#include <thelma/base/quantity.h>
#include <thelma/materials/thermal.h>

namespace thelma
{

void Thermal::declare(dealii::ParameterHandler& prm)
{
  add_quantity(prm, "Bulk modulus", K, "K; default 1000 mu(293 K).", Quantity("MPa"));
  add_quantity(prm, "Thermal expansion", alpha, "Linear coefficient alpha.", Quantity("1/K"));
  add_quantity(prm, "Reference temperature", theta_0,
               "theta_0, where the material is free of stress at F = I.", Quantity("K", 1.));
  add_quantity(prm, "Heat capacity", c, "c, per reference volume.", Quantity("MJ/(m^3 K)", 0.));
  add_quantity(prm, "Conductivity", k, "k.", Quantity("W/(m K)", 0.));
}

HeatFlux Thermal::heat_flux(const Kinematics<>& kin, const Tensor3<1>& grad_theta) const
{
  const Tensor3<2>& G = kin.G;
  const Tensor3<1> g = G * grad_theta, d = g * G;
  const Tensor3<2> C_inv = dealii::transpose(G) * G;
  const double k_J = k * kin.J;
  HeatFlux flux;
  flux.Q = -k_J * d;
  flux.dQ_dgrad = -k_J * C_inv;
  for (unsigned int J = 0; J < 3; ++J)
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int L = 0; L < 3; ++L)
        flux.dQ_dF[J][i][L] = -k_J * (d[J] * G[i][L] - d[L] * G[i][J] - C_inv[J][L] * g[i]);
  return flux;
}

} // namespace thelma
