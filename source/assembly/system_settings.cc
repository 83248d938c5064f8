#include <thelma/assembly/system_settings.h>
#include <thelma/base/parameters.h>
#include <thelma/elements/formulation.h>

namespace thelma
{

void SystemSettings::declare(dealii::ParameterHandler& prm)
{
  linear.declare(prm);
  std::string names; // the same in two and three dimensions
  for (const std::string& name : formulations<2>().names())
    names += (names.empty() ? "" : "|") + name;
  const Section section(prm, {"Discretisation"});
  prm.add_parameter("Formulation", formulation,
                    "Element formulation: how the nearly incompressible volumetric energy is "
                    "integrated.",
                    dealii::Patterns::Selection(names));
}

} // namespace thelma
