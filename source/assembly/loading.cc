#include <thelma/assembly/loading.h>
#include <thelma/base/parameters.h>

#include <cmath>
#include <sstream>

namespace thelma
{

void Loading::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Loading"});
  prm.add_parameter("Control", control,
                    "What Target is: the `voltage` in kV or the dimensionless field `e`.",
                    Selection("voltage|e"));
  prm.add_parameter("Target", target, "Where the run ends unless an instability ends it before.",
                    Double(1e-12));
  prm.add_parameter("Film thickness", film_thickness,
                    "Thickness h in mm of the film between the electrodes, for e = V/h "
                    "sqrt(eps/mu(theta)).",
                    Double(1e-12));
  prm.add_parameter("Film material", film_material,
                    "Material whose eps and mu(theta) enter e; empty: the only one there is.",
                    Anything());
  prm.add_parameter("Bracket", bracket,
                    "A pull-in is enclosed between two fields e this far apart; also the smallest "
                    "load step.",
                    Double(1e-12));
  prm.add_parameter("Until", until_values,
                    "Where a path that is followed through instabilities ends before Target, as "
                    "`column: value` of the curve.",
                    Map(Anything(), Double(), 0, 1));
  prm.add_parameter("Expected end", expected_end,
                    "`target`: an instability before the target is exit code 3; `pull-in`: it is "
                    "the aim.",
                    Selection("target|pull-in"));
}

void Loading::setup(const MaterialLibrary& materials, const double theta)
{
  if (film_material.empty()) {
    const std::vector<std::string> names = materials.names();
    if (names.size() != 1)
      throw InputError("section Loading, entry 'Film material': say which material's eps and mu "
                       "define e; known: " +
                       comma_separated(names));
    film_material = names.front();
  }
  const Material& film = materials.named(film_material);
  field_per_voltage =
      std::sqrt(film.permittivity(theta) / film.shear_modulus(theta)) / film_thickness;
  target_voltage = control == "e" ? target / field_per_voltage : target;
}

std::string Loading::description() const
{
  std::ostringstream text;
  text << "loading: voltage to " << target_voltage << " kV, e = " << field(target_voltage);
  return text.str();
}

} // namespace thelma
