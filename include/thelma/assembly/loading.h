#pragma once

#include <thelma/materials/list.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace thelma
{

/// One stage of a run: a quantity goes to a multiple of its target while the load factor goes from
/// 0 to 1, or an electrode changes.
struct Stage {
  enum class Kind { voltage, charge, force, pressure, move, connect, disconnect };
  Kind kind;
  double level = 0.;     ///< of a quantity, at the end
  std::string electrode; ///< that changes
  bool is_electric() const { return kind == Kind::voltage || kind == Kind::charge; }
  bool is_ramp() const { return kind != Kind::connect && kind != Kind::disconnect; }
};

/// Multiples of their targets that the quantities have reached.
struct Levels {
  double voltage = 0., charge = 0., force = 0., pressure = 0., motion = 0.;
  double& of(const Stage::Kind kind)
  {
    return kind == Stage::Kind::voltage    ? voltage
           : kind == Stage::Kind::charge   ? charge
           : kind == Stage::Kind::force    ? force
           : kind == Stage::Kind::pressure ? pressure
                                           : motion;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& voltage& charge& force& pressure& motion;
  }
};

/// What the load factor means: a voltage in kV, a charge in uC or a dimensionless nominal field
///   e = V / h sqrt(eps / mu(theta))      (theory.md, eq. 17).
class Loading
{
public:
  /// What the target is.
  enum class Control { voltage, e, charge };

  void declare(dealii::ParameterHandler& prm);

  /// Fix the film's properties at the uniform (or initial) temperature @p theta in K.
  void setup(const MaterialLibrary& materials, double theta);

  double voltage(double level) const { return level * target_voltage; } ///< kV
  double charge(double level) const { return level * target_charge; }   ///< uC
  double field(double voltage) const { return voltage * field_per_voltage; }

  double thickness() const { return film_thickness; } ///< mm

  /// Width of the bracket around a pull-in, as a part of the target.
  double resolution() const
  {
    return target_voltage > 0. ? bracket / field(target_voltage) : bracket;
  }

  const std::vector<Stage>& stages() const { return stage_list; }

  bool has_stage(Stage::Kind kind) const;

  /// Whether a stage of this kind changes this electrode.
  bool has_stage(Stage::Kind kind, const std::string& electrode) const;

  /// Column of the curve at whose value the path ends, if there is one.
  const std::map<std::string, double>& until() const { return until_values; }

  bool expects_pull_in() const { return expected_end == ExpectedEnd::pull_in; }
  std::string description() const;

  /// What the quantity of a stage is at these @p levels, as a sentence names it.
  std::string between(Stage::Kind kind, double low, double high) const;

private:
  enum class ExpectedEnd { target, pull_in };

  const Material& film_of(const MaterialLibrary& materials) const;
  double read_target() const;
  void read_stages();
  void check_that_stages_go_anywhere() const;

  Control control = Control::e;
  ExpectedEnd expected_end = ExpectedEnd::target;
  std::string target_text = "1", film_material;

  std::map<std::string, double> until_values;
  std::vector<std::string> stage_texts;
  std::vector<Stage> stage_list;
  double film_thickness = 1., bracket = 1e-4;
  double target_voltage = 0., target_charge = 0., field_per_voltage = 0.;
};

} // namespace thelma
