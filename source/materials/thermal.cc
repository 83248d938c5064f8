#include <thelma/materials/thermal.h>

namespace thelma
{

void Thermal::declare(dealii::ParameterHandler& prm)
{
  using dealii::Patterns::Double;
  prm.add_parameter("Bulk modulus", K, "K in MPa; default 1000 mu(293 K).");
  prm.add_parameter("Thermal expansion", alpha, "Linear coefficient alpha in 1/K.");
  prm.add_parameter("Reference temperature", theta_0,
                    "theta_0 in K, where the material is free of stress at F = I.", Double(1.));
  prm.add_parameter("Heat capacity", c, "Per reference volume, c in MPa/K (1 MJ/(m^3 K)).",
                    Double(0.));
  prm.add_parameter("Conductivity", k, "k in N/(s K) (1 W/(m K)).", Double(0.));
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
