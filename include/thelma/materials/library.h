#pragma once

#include <thelma/base/named_list.h>
#include <thelma/base/parameters.h>
#include <thelma/materials/material.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace thelma
{

std::vector<Choice> elastic_laws();
std::vector<Choice> dielectric_laws();
std::vector<Choice> branch_laws();

/// A temperature that a scene is known to have, in K, and the entry that says so.
struct KnownTemperature {
  double theta;
  std::string entry;
};

/// Materials by name, and which one fills each named region of the mesh.
class MaterialLibrary
{
public:
  /// Reads the choices of @p file leniently and builds the materials they name.
  explicit MaterialLibrary(const ParameterFile& file);

  void declare(dealii::ParameterHandler& prm);

  /// Finds moduli that follow others. Throws InputError for those that make no sense at @p theta.
  void check(double theta);

  /// The same of what depends on the temperature, where a scene is known to have it.
  void check_at(const KnownTemperature& known) const;

  /// The same of what conducts and, if the temperature changes @p in_time, stores heat; and whether
  /// the structural heat, if it is that of the power (@p by_power), is known.
  void check_heat(bool in_time, bool by_power) const;

  /// A material with internal variables; empty if there is none.
  std::string one_that_remembers() const;

  /// A line for each material: where it is, its laws and moduli at @p theta in K.
  std::vector<std::string> summary(double theta) const;

  /// Warnings about moduli that do not fit each other, a sentence each.
  std::vector<std::string> doubts() const;

  /// Common temperature in K at which the undeformed materials are free of stress.
  /// Throws InputError if they differ.
  double reference_temperature() const;

  const Material& of_region(const std::string& region) const;

  /// Throws InputError, with @p place in the sentence, for an unknown name.
  const Material& named(const std::string& name, const std::string& place) const;
  std::vector<std::string> regions() const;
  std::vector<std::string> names() const;

private:
  struct Entry {
    Entry();
    std::string elastic, dielectric;   ///< laws
    std::vector<std::string> branches; ///< laws
    std::unique_ptr<Material> material;
    bool has_section = false; ///< in the file
  };

  void declare_regions(dealii::ParameterHandler& prm);
  static void declare_laws(dealii::ParameterHandler& prm, const std::string& name, Entry& entry);

  std::map<std::string, std::string> material_of_region;
  std::map<std::string, Entry> materials;
};

} // namespace thelma
