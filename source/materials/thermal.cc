#include <thelma/base/quantity.h>
#include <thelma/materials/thermal.h>

namespace thelma
{

void Thermal::declare(dealii::ParameterHandler& prm)
{
  add_quantity(prm, "Bulk modulus", K, "K; default 1000 mu(293 K).", Quantity("MPa"));
  add_quantity(prm, "Thermal expansion", alpha, "Linear coefficient alpha.", Quantity("1/K"));
  add_quantity(prm, "Reference temperature", theta_0,
               "theta_0, where the material is free of stress at F = I.", Quantity("K", 1., 1e4));
  add_quantity(prm, "Heat capacity", c, "c, per reference volume.", Quantity("MJ/(m^3 K)", 0.));
  add_quantity(prm, "Conductivity", k, "k.", Quantity("W/(m K)", 0.));
}

} // namespace thelma
