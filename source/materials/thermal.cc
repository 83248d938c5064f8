#include <thelma/base/error.h>
#include <thelma/base/quantity.h>
#include <thelma/materials/thermal.h>

namespace thelma
{

void Thermal::declare(dealii::ParameterHandler& prm)
{
  add_quantity(
      prm, "Bulk modulus", K,
      "K, the factor of ln^2 J, equal to Lame's lambda: the small-strain bulk modulus is K + 2 "
      "mu/3. Default 1000 mu(293 K).",
      Quantity("MPa"));
  add_quantity(prm, "Bulk over shear modulus", K_over_mu,
               "K/mu(theta_0), an alternative to K, which then changes with mu; 0: K is given.",
               Quantity("1", 0.));
  add_quantity(prm, "Poisson ratio", poisson_ratio,
               "nu, an alternative to K, which is then 2 mu(theta_0) nu/(1 - 2 nu); 0: K is given.",
               Quantity("1", 0., 0.4999999));
  add_quantity(prm, "Thermal expansion", alpha, "Linear coefficient alpha.", Quantity("1/K"));
  add_quantity(prm, "Reference temperature", theta_0,
               "theta_0, at which the material is stress-free for F = I.", Quantity("K", 1., 1e4));
  add_quantity(prm, "Heat capacity", c, "c, per reference volume.", Quantity("MJ/(m^3 K)", 0.));
  add_quantity(prm, "Conductivity", k, "k.", Quantity("W/(m K)", 0.));
}

void Thermal::follow(const double mu)
{
  const bool has_K = K != Thermal().K;
  if (has_K + (K_over_mu > 0.) + (poisson_ratio > 0.) > 1)
    throw InputError(
        "it is given by more than one of 'Bulk modulus', 'Bulk over shear modulus' and "
        "'Poisson ratio'; keep one");
  if (K_over_mu > 0.)
    K = K_over_mu * mu;
  if (poisson_ratio > 0.)
    K = 2. * mu * poisson_ratio / (1. - 2. * poisson_ratio);
}

} // namespace thelma
