#include <thelma/base/error.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/parameters.h>
#include <thelma/base/units.h>
#include <thelma/fields/electrodes.h>
#include <thelma/fields/named_dofs.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <set>

namespace thelma
{
namespace
{

/// Declares an entry of multiples of what the section Loading applies, by the names of electrodes.
void add_multiples(dealii::ParameterHandler& prm, const std::string& entry,
                   std::map<std::string, double>& multiples, const std::string& sentence,
                   const std::string& control, const std::string& unit)
{
  using namespace dealii::Patterns;
  using Map = std::map<std::string, std::string>;
  prm.declare_entry(entry, "", dealii::Patterns::Map(Anything(), Anything(), 0, 100), sentence);
  prm.add_action(entry, [&multiples, control, unit](const std::string& text) {
    multiples.clear();
    for (const auto& [name, value] : Tools::Convert<Map>::to_value(text)) {
      const NumberWithUnit given(value, "1");
      if (!given.unit.empty())
        throw InputError("'" + value + "' has a unit, but is to be a multiple of the applied " +
                         control + "; write `" + name + ": 1`, and in the section Loading `set " +
                         "Control = " + control + "` and `set Target = 4 " + unit +
                         "` or the like");
      multiples[name] = given.number;
    }
  });
}

} // namespace

double Electrode::own_sum(const BlockVector& x) const
{
  const auto owned = x.locally_owned_elements();
  double sum = 0.;
  for (const auto dof : dofs)
    if (owned.is_element(dof))
      sum += x(dof);
  return sum;
}

template <int dim>
void Electrodes<dim>::declare(dealii::ParameterHandler& prm)
{
  const Section section(prm, {"Electrodes"});
  add_multiples(prm, "Potential", driven,
                "Potential of each electrode as a multiple of the applied voltage, as `bottom: 0, "
                "top: 1`; 0 is ground.",
                "voltage", "kV");
  add_multiples(prm, "Floating", floating,
                "Electrodes whose potential is an unknown, each with its charge as a multiple of "
                "the applied one, as `top: 1`; 0 is without charge.",
                "charge", "uC");
}

template <int dim>
void Electrodes<dim>::setup(const Mesh<dim>& mesh, const DofLayout<dim>& layout)
{
  const std::string place = "section Electrodes, entry 'Potential'";
  if (!layout.has(Field::potential)) {
    if (!driven.empty() || !floating.empty())
      throw InputError(place + ": every region is passive, so there is no potential; remove the "
                               "electrodes or make a region active");
    return;
  }
  InputErrors errors;
  const auto is_ground = [](const auto& electrode) { return electrode.second == 0.; };
  if (std::none_of(driven.begin(), driven.end(), is_ground))
    errors.add(place + ": there is no ground electrode; give one surface the potential 0");
  for (const auto& [name, multiple] : driven)
    errors.collect([&, &name = name, &multiple = multiple]() {
      add(mesh, layout, {name, {}, multiple, 0., 0., false}, place);
    });
  const std::string floating_place = "section Electrodes, entry 'Floating'";
  for (const auto& [name, multiple] : floating)
    errors.collect([&, &name = name, &multiple = multiple]() {
      if (driven.count(name) > 0)
        throw InputError(floating_place + ": electrode '" + name +
                         "' is in the entry 'Potential', too; it either floats or has a given "
                         "potential");
      add(mesh, layout, {name, {}, 1., multiple, 0., true}, floating_place);
    });
  errors.raise();
}

template <int dim>
void Electrodes<dim>::add(const Mesh<dim>& mesh, const DofLayout<dim>& layout, Electrode electrode,
                          const std::string& place)
{
  require_off_axis(mesh, electrode.name, place);
  const auto dofs =
      dofs_on(mesh, layout, electrode.name, place, layout[Field::potential].component);
  if (dofs.empty())
    throw InputError(place + ": surface '" + electrode.name +
                     "' touches only regions without electric field");
  std::set<dealii::types::global_dof_index> own(dofs.begin(), dofs.end());
  for (Electrode& other : list) {
    const bool alike =
        !electrode.floats && !other.floats && electrode.voltage_multiple == other.voltage_multiple;
    bool touches = false;
    for (const auto dof : other.dofs)
      touches |= own.erase(dof) > 0; // a charge belongs to one of the two
    if (touches)
      electrode.touches = other.touches = true;
    if (touches && !alike)
      throw InputError(place + ": electrode '" + electrode.name + "' touches '" + other.name +
                       "', which has another potential: a short circuit; give both the same, or "
                       "leave a gap");
  }
  if (own.empty())
    throw InputError(place + ": electrode '" + electrode.name +
                     "' lies within others of the same potential; leave it out");
  electrode.dofs.assign(own.begin(), own.end());
  list.push_back(std::move(electrode));
}

template <int dim>
Electrode& Electrodes<dim>::find(const std::string& name)
{
  return *std::find_if(list.begin(), list.end(),
                       [&](const Electrode& electrode) { return electrode.name == name; });
}

template <int dim>
const Electrode& Electrodes<dim>::named(const std::string& name, const std::string& place) const
{
  std::vector<std::string> known;
  for (const Electrode& electrode : list) {
    if (electrode.name == name)
      return electrode;
    known.push_back(electrode.name);
  }
  throw InputError(place + ": there is no electrode '" + name + "'" + did_you_mean(name, known));
}

template <int dim>
std::vector<const Electrode*> Electrodes<dim>::live() const
{
  using Belongs = bool (*)(const Electrode&);
  const Belongs driven_up = [](const Electrode&e) { return !e.floats && e.voltage_multiple > 0.; },
                driven_down =
                    [](const Electrode&e) { return !e.floats && e.voltage_multiple < 0.; },
                charged_up =
                    [](const Electrode&e) {
                      return e.charge_multiple > 0. ||
                             (e.kept_charge != 0. && e.voltage_multiple > 0.);
                    },
                charged = [](const Electrode&e) {
                  return (e.charge_multiple != 0. || e.kept_charge != 0.) &&
                         e.voltage_multiple != 0.;
                };
  std::vector<const Electrode*> found;
  for (const Belongs belongs : {driven_up, driven_down, charged_up, charged}) {
    for (const Electrode& electrode : list)
      if (belongs(electrode))
        found.push_back(&electrode);
    if (!found.empty())
      break;
  }
  return found;
}

template <int dim>
void Electrodes<dim>::disconnect(const std::string& name, const double charge)
{
  Electrode& electrode = find(name);
  electrode.floats = true;
  electrode.kept_charge = charge;
}

template <int dim>
void Electrodes<dim>::connect(const std::string& name)
{
  find(name).floats = false;
}

template <int dim>
double potential(const Electrode& electrode, const DofLayout<dim>& layout, const BlockVector& x)
{
  const auto dof = electrode.dofs.front();
  const double own = layout.dof_handler().locally_owned_dofs().is_element(dof) ? x(dof) : 0.;
  return dealii::Utilities::MPI::sum(own, layout.communicator());
}

template class Electrodes<2>;
template class Electrodes<3>;
template double potential(const Electrode&, const DofLayout<2>&, const BlockVector&);
template double potential(const Electrode&, const DofLayout<3>&, const BlockVector&);

} // namespace thelma
