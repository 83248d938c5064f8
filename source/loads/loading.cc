#include <thelma/base/error.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/option_names.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/loads/loading.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace thelma
{
namespace
{

OptionNames<Loading::Control> controls()
{
  return {{{"voltage", Loading::Control::voltage},
           {"e", Loading::Control::e},
           {"charge", Loading::Control::charge}}};
}

} // namespace

void Loading::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Loading"});
  controls().declare(prm, "Control", control,
                     "What Target is: the `voltage` in kV, the dimensionless field `e`, or the "
                     "`charge` in uC of floating electrodes.");
  prm.add_parameter("Target", target_text,
                    "Where the run ends unless an instability ends it before. Unit: that of "
                    "Control, kV, none or uC.",
                    Anything());
  add_quantity(prm, "Film thickness", film_thickness,
               "Thickness h of the film between the electrodes, for e = V/h sqrt(eps/mu(theta)).",
               Quantity("mm", 1e-12));
  prm.add_parameter("Film material", film_material,
                    "Material whose eps and mu(theta) enter e; empty: the only one there is.",
                    Anything());
  prm.add_parameter("Bracket", bracket,
                    "A pull-in is enclosed between two fields e this far apart; also the smallest "
                    "load step.",
                    Double(1e-12, 1.));
  all_stages.declare(prm);
  prm.add_parameter("Until", until_values,
                    "Where a path that is followed through instabilities ends before Target, as "
                    "`column: value` of the curve.",
                    Map(Anything(), Double(), 0, 1));
  OptionNames<ExpectedEnd>({{"target", ExpectedEnd::target}, {"pull-in", ExpectedEnd::pull_in}})
      .declare(prm, "Expected end", expected_end,
               "`target`: an instability before the target is exit code 3; `pull-in`: it is "
               "the aim.");
}

void Loading::setup(const MaterialLibrary& materials, const double theta,
                    const std::vector<std::string>& loads)
{
  InputErrors errors;
  double target = 0.;
  errors.collect([&]() {
    const Material& film = film_of(materials);
    field_per_voltage =
        std::sqrt(film.permittivity(theta) / film.shear_modulus(theta)) / film_thickness;
  });
  errors.collect([&]() { target = read_target(); });
  errors.collect(
      [&]() { all_stages.read(loads, control == Control::charge ? "charge" : "voltage"); });
  errors.raise();
  const auto index = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(loads.begin(), loads.end(), name) - loads.begin());
  };
  voltage = index("voltage");
  charge = index("charge");
  if (control == Control::charge)
    target_uC = target;
  else
    target_kV = control == Control::e ? target / field_per_voltage : target;
}

const Material& Loading::film_of(const MaterialLibrary& materials) const
{
  const std::string place = "section Loading, entry 'Film material'";
  const std::vector<std::string> names = materials.names();
  if (film_material.empty() && names.size() != 1)
    throw InputError(
        place + ": say which material's eps and mu define e; known: " + comma_separated(names));
  return materials.named(film_material.empty() ? names.front() : film_material, place);
}

double Loading::read_target() const
{
  if (dealii::Utilities::trim(target_text).rfind('-', 0) == 0)
    throw InputError("section Loading, entry 'Target': '" + target_text +
                     "' is negative; write a positive one and turn the signs around in the section "
                     "Electrodes, as `top: -1`");
  try {
    return Quantity(control == Control::e         ? "1"
                    : control == Control::voltage ? "kV"
                                                  : "uC",
                    1e-12, 1e6)
        .value(target_text);
  } catch (const InputError& error) {
    throw InputError("section Loading, entry 'Target': " + std::string(error.what()) +
                     ", or choose another Control than " + controls().name(control));
  }
}

std::string Loading::description() const
{
  std::ostringstream text;
  if (!all_stages.drive(voltage) && !all_stages.drive(charge))
    text << "loading: no stage applies a voltage or a charge";
  else if (control == Control::charge)
    text << "loading: charge to " << target_uC << " uC";
  else
    text << "loading: voltage to " << target_kV << " kV, e = " << field(target_kV);
  return text.str();
}

} // namespace thelma
