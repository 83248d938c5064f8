#pragma once

#include <thelma/materials/temperature_law.h>
#include <thelma/materials/true_field.h>

#include <string>

namespace thelma
{

constexpr double vacuum_permittivity = 8.8541878e-6; ///< N/kV^2

/// What all dielectric laws have: the permittivity of the undeformed material in weak fields.
class Permittivity
{
public:
  void declare(dealii::ParameterHandler& prm)
  {
    eps.declare(prm, "Permittivity", "eps(theta).", Quantity("N/kV^2"));
  }

  /// In N/kV^2.
  double permittivity(const double theta) const { return eps.value(theta); }

  std::string table_defect(const double theta) const { return eps.table_defect(theta); }

protected:
  TemperatureLaw eps{{3.98e-5}};
};

} // namespace thelma
