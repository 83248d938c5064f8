#include <thelma/base/error.h>
#include <thelma/materials/material_checks.h>

#include <cmath>

namespace thelma
{

void require_positive(const std::string& material, const std::string& entry, const double value,
                      const std::string& where)
{
  if (!(value > 0.))
    throw InputError("section Materials/" + material + ", entry '" + entry + "': the value is " +
                     as_text(value) + where + " but must be positive");
}

void require_in_tables(const Material& material, const KnownTemperature& known)
{
  if (const std::string defect = material.table_defect(known.theta); !defect.empty())
    throw InputError(defect + ", without the " + as_text(known.theta) + " K of " + known.entry +
                     "; add rows that reach it");
}

void require_stable_rest(const Material& material, const double theta)
{
  constexpr double negligible = 1e-6;
  const std::string start = "section Materials/" + material.name + ", entry 'Energy': at " +
                            as_text(theta) + " K the body without load has a ";
  const double mu = material.shear_modulus(theta);
  if (!(mu > 0.))
    throw InputError(start + "shear modulus of " + as_text(mu) + " MPa, which must be positive");
  const double stretch = 1. / material.thermal.split(theta);
  const Tensor3<2> F({{stretch, 0., 0.}, {0., stretch, 0.}, {0., 0., stretch}});
  FirstDerivatives<> first{};
  material.evaluate({F, Tensor3<1>(), theta}, first);
  const double W_F = first.P[0][0] * stretch * material.thermal.theta_0 / theta;
  if (!(std::abs(W_F) <= negligible * mu))
    throw InputError(start + "stress of " + as_text(W_F) + " MPa; add " + as_text(-W_F) +
                     "*log(J) to the energy");
}

} // namespace thelma
