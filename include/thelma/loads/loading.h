#pragma once

#include <thelma/loads/stages.h>
#include <thelma/materials/library.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace thelma
{

/// What the load factor means: a voltage in kV, a charge in uC or a dimensionless nominal field
///   e = V / h sqrt(eps / mu(theta))      (theory.md, eq. 53).
class Loading
{
public:
  /// What the target is.
  enum class Control { voltage, e, charge };

  void declare(dealii::ParameterHandler& prm);

  /// Fix the film's properties at the uniform (or initial) temperature @p theta in K; @p loads are
  /// the names of all loads, empty for those that no stage drives. Throws InputError.
  void setup(const MaterialLibrary& materials, double theta, const std::vector<std::string>& loads);

  double target_voltage() const { return target_kV; } ///< 0 where a charge is the target
  double target_charge() const { return target_uC; }  ///< 0 where a voltage is the target
  double field(double voltage) const { return voltage * field_per_voltage; }

  double thickness() const { return film_thickness; } ///< mm

  /// Width of the bracket around a pull-in, as a part of the target.
  double resolution() const { return target_kV > 0. ? bracket / field(target_kV) : bracket; }

  const Stages& stages() const { return all_stages; }

  /// Column of the curve at whose value the path ends, if there is one.
  const std::map<std::string, double>& until() const { return until_values; }

  bool expects_pull_in() const { return expected_end == ExpectedEnd::pull_in; }
  std::string description() const;

private:
  enum class ExpectedEnd { target, pull_in };

  const Material& film_of(const MaterialLibrary& materials) const;
  double read_target() const;

  Control control = Control::e;
  ExpectedEnd expected_end = ExpectedEnd::target;
  std::string target_text = "1", film_material;

  std::map<std::string, double> until_values;
  Stages all_stages;
  std::size_t voltage = 0, charge = 0; ///< in the list of loads
  double film_thickness = 1., bracket = 1e-4;
  double target_kV = 0., target_uC = 0., field_per_voltage = 0.;
};

} // namespace thelma
