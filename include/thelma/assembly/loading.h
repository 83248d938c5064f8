#pragma once

#include <thelma/materials/list.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>

namespace thelma
{

/// What the load factor means: a voltage in kV or a dimensionless nominal field
///   e = V / h sqrt(eps / mu(theta))      (theory.md, eq. 17).
class Loading
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Fix the film's properties at the uniform (or initial) temperature @p theta in K.
  void setup(const MaterialLibrary& materials, double theta);

  double voltage(double load) const { return load * target_voltage; } ///< kV
  double field(double voltage) const { return voltage * field_per_voltage; }

  /// Width of the bracket around a pull-in, as a load factor.
  double resolution() const { return bracket / field(target_voltage); }

  /// Column of the curve at whose value the path ends, if there is one.
  const std::map<std::string, double>& until() const { return until_values; }

  bool expects_pull_in() const { return expected_end == "pull-in"; }
  std::string description() const;

private:
  std::string control = "e", expected_end = "target", film_material;
  std::map<std::string, double> until_values;
  double target = 1., film_thickness = 1., bracket = 1e-4;
  double target_voltage = 0., field_per_voltage = 0.;
};

} // namespace thelma
