#include <thelma/base/input_errors.h>
#include <thelma/mesh/gmsh_parameters.h>

#include <boost/property_tree/json_parser.hpp>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace thelma
{
namespace
{

/// Numbers of cells and the like are declared with a whole Step: throws InputError unless @p value
/// is a multiple of it and between the Min and the Max of the parameter @p name. (To a parameter
/// without any of these gmsh gives limits of its own, which mean nothing, and no whole step.)
void require_allowed(const std::string& file, const std::string& name, const double value)
{
  std::string description;
  gmsh::onelab::get(description, name);
  std::istringstream json(description);
  boost::property_tree::ptree parameter;
  boost::property_tree::read_json(json, parameter);
  const auto refuse = [&](const std::string& remedy) {
    throw InputError("section Mesh, entry 'Parameters': '" + name + "' of '" + file + "' is " +
                     as_text(value) + " but must be " + remedy);
  };
  const double step = parameter.get("step", 0.);
  if (step < 1. || step != std::round(step))
    return;
  if (std::fmod(value, step) != 0.)
    refuse(step == 1. ? "a whole number" : "a multiple of " + as_text(step));
  if (const double least = parameter.get("min", value); value < least)
    refuse("at least " + as_text(least));
  if (const double most = parameter.get("max", value); value > most)
    refuse("at most " + as_text(most));
}

} // namespace

void set_parameters(const std::string& file, const std::map<std::string, double>& parameters)
{
  std::vector<std::string> known;
  gmsh::onelab::getNames(known);
  const auto belongs_to_gmsh = [](const std::string& n) {
    return n.find('/') != std::string::npos;
  };
  known.erase(std::remove_if(known.begin(), known.end(), belongs_to_gmsh), known.end());
  InputErrors errors;
  for (const auto& [name, value] : parameters)
    errors.collect([&, &name = name, &value = value]() {
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw InputError("section Mesh, entry 'Parameters': '" + file + "' has no parameter '" +
                         name + "'" + did_you_mean(name, known));
      require_allowed(file, name, value);
    });
  errors.raise();
  gmsh::clear();
  gmsh::option::setNumber("Mesh.ScalingFactor", 1.); // the file may not set it with these
  for (const auto& [name, value] : parameters)
    gmsh::onelab::setNumber(name, {value});
}

} // namespace thelma
