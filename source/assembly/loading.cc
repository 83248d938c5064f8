#include <thelma/assembly/loading.h>
#include <thelma/base/complaints.h>
#include <thelma/base/error.h>
#include <thelma/base/option_names.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>

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
  prm.add_parameter("Stages", stage_texts,
                    "What happens one after the other: `voltage 1` or `charge 1` goes to this "
                    "multiple of Target, `force 1` or `pressure 1` to this multiple of Loads/Force "
                    "or Loads/Pressure, `move 1` takes Supports/Moved along this part of their "
                    "way, `disconnect NAME` lets an electrode float with its charge and `connect "
                    "NAME` drives it from its potential. Empty: `voltage 1`, or `charge 1`.",
                    List(Anything(), 0, 100));
  prm.add_parameter("Until", until_values,
                    "Where a path that is followed through instabilities ends before Target, as "
                    "`column: value` of the curve.",
                    Map(Anything(), Double(), 0, 1));
  OptionNames<ExpectedEnd>({{"target", ExpectedEnd::target}, {"pull-in", ExpectedEnd::pull_in}})
      .declare(prm, "Expected end", expected_end,
               "`target`: an instability before the target is exit code 3; `pull-in`: it is "
               "the aim.");
}

void Loading::setup(const MaterialLibrary& materials, const double theta)
{
  Complaints complaints;
  double target = 0.;
  complaints.allow([&]() {
    const Material& film = film_of(materials);
    field_per_voltage =
        std::sqrt(film.permittivity(theta) / film.shear_modulus(theta)) / film_thickness;
  });
  complaints.allow([&]() { target = read_target(); });
  complaints.allow([&]() { read_stages(); });
  complaints.raise();
  if (control == Control::charge)
    target_charge = target;
  else
    target_voltage = control == Control::e ? target / field_per_voltage : target;
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

/// Throws InputError for a stage that is where it goes to.
void Loading::check_that_stages_go_anywhere() const
{
  std::map<Stage::Kind, double> levels{{Stage::Kind::voltage, 0.},
                                       {Stage::Kind::charge, 0.},
                                       {Stage::Kind::force, 0.},
                                       {Stage::Kind::pressure, 0.},
                                       {Stage::Kind::move, 0.}};
  for (std::size_t n = 0; n < stage_list.size(); ++n) {
    const Stage& stage = stage_list[n];
    if (stage.kind == Stage::Kind::connect)
      levels.erase(Stage::Kind::voltage); // it becomes what the electrode has
    if (!stage.is_ramp())
      continue;
    const auto now = levels.find(stage.kind);
    if (now != levels.end() && now->second == stage.level)
      throw InputError("section Loading, entry 'Stages': '" + stage_texts[n] +
                       "' changes nothing, as it is there already; remove it or write another "
                       "number");
    levels[stage.kind] = stage.level;
  }
}

void Loading::read_stages()
{
  const std::map<std::string, Stage::Kind> kinds{{"voltage", Stage::Kind::voltage},
                                                 {"charge", Stage::Kind::charge},
                                                 {"force", Stage::Kind::force},
                                                 {"pressure", Stage::Kind::pressure},
                                                 {"move", Stage::Kind::move},
                                                 {"connect", Stage::Kind::connect},
                                                 {"disconnect", Stage::Kind::disconnect}};
  if (stage_texts.empty()) {
    stage_list = {{kinds.at(control == Control::charge ? "charge" : "voltage"), 1., ""}};
    return;
  }
  for (const std::string& text : stage_texts) {
    std::istringstream words(text);
    std::string word, rest;
    words >> word;
    const auto found = kinds.find(word);
    Stage stage{found == kinds.end() ? Stage::Kind::voltage : found->second, 0., ""};
    const bool read =
        found != kinds.end() && (stage.is_ramp() ? words >> stage.level : words >> stage.electrode);
    if (!read || words >> rest)
      throw InputError("section Loading, entry 'Stages': '" + text +
                       "' is no stage; write voltage, charge, force, pressure or move with a "
                       "number, or connect or disconnect with an electrode");
    stage_list.push_back(stage);
  }
  check_that_stages_go_anywhere();
}

bool Loading::has_stage(const Stage::Kind kind) const
{
  return std::any_of(stage_list.begin(), stage_list.end(),
                     [&](const Stage& stage) { return stage.kind == kind; });
}

bool Loading::has_stage(const Stage::Kind kind, const std::string& electrode) const
{
  return std::any_of(stage_list.begin(), stage_list.end(), [&](const Stage& stage) {
    return stage.kind == kind && stage.electrode == electrode;
  });
}

std::string Loading::between(const Stage::Kind kind, const double low, const double high) const
{
  const double unit = kind == Stage::Kind::voltage  ? field(voltage(1.))
                      : kind == Stage::Kind::charge ? charge(1.)
                                                    : 1.;
  std::ostringstream text;
  text.precision(7);
  text << "between " << (kind == Stage::Kind::voltage ? "e = " : "") << unit * low << " and "
       << unit * high
       << (kind == Stage::Kind::voltage    ? ""
           : kind == Stage::Kind::charge   ? " uC"
           : kind == Stage::Kind::force    ? " times the force"
           : kind == Stage::Kind::pressure ? " times the pressure"
                                           : " of the way of the moved supports");
  return text.str();
}

std::string Loading::description() const
{
  std::ostringstream text;
  if (!has_stage(Stage::Kind::voltage) && !has_stage(Stage::Kind::charge))
    text << "loading: no stage applies a voltage or a charge";
  else if (control == Control::charge)
    text << "loading: charge to " << target_charge << " uC";
  else
    text << "loading: voltage to " << target_voltage << " kV, e = " << field(target_voltage);
  return text.str();
}

} // namespace thelma
