#include <thelma/base/axes.h>
#include <thelma/base/complaints.h>
#include <thelma/base/error.h>
#include <thelma/base/formula.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/named_dofs.h>
#include <thelma/fields/rigid_motions.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <memory>

namespace thelma
{
namespace
{

/// Where a moved support goes at the point @p X: a length or an expression of x1, x2, x3.
template <int dim>
std::function<double(const dealii::Point<dim>&)> moved_way(const std::string& text,
                                                           const std::string& place)
{
  if (text.find('x') != std::string::npos) {
    const auto formula = std::make_shared<Formula<3>>(place, text, "x1,x2,x3");
    return [formula](const dealii::Point<dim>& X) {
      dealii::Point<3> in_space;
      for (unsigned int d = 0; d < dim; ++d)
        in_space[axis<dim>(d)] = X[d];
      return (*formula)(in_space);
    };
  }
  try {
    const double way = Quantity("mm").value(text);
    return [way](const dealii::Point<dim>&) { return way; };
  } catch (const InputError& error) {
    throw InputError(place + ": " + error.what());
  }
}

/// A text such as "u1 2.5 u3 0.2*x3", by components.
std::vector<std::pair<std::string, std::string>> moved_components(const std::string& text,
                                                                  const std::string& place)
{
  std::vector<std::pair<std::string, std::string>> parts;
  for (const std::string& word : dealii::Utilities::split_string_list(text, ' '))
    if (word.size() == 2 && word[0] == 'u')
      parts.emplace_back(word, "");
    else if (!parts.empty())
      parts.back().second += (parts.back().second.empty() ? "" : " ") + word;
  for (const auto& part : parts)
    if (part.second.empty())
      parts.clear();
  if (parts.empty())
    throw InputError(place + ": '" + text +
                     "' is not a displacement component and mm; write it as u1 2.5");
  return parts;
}

} // namespace

template <int dim>
void BoundaryConditions<dim>::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  {
    const Section section(prm, {"Supports"});
    prm.add_parameter("Fixed", supports,
                      "Displacement components held at zero on surfaces, lines or points, as "
                      "`clamp: u1 u2 u3, symmetry: u1`.",
                      Map(Anything(), Anything(), 0, 100));
    prm.add_parameter(
        "Moved", moved_supports,
        "Displacement components to which the stage `move` (Loading/Stages) takes "
        "surfaces, lines or points, as `grip: u1 2.5`, in mm or as an expression of x1, x2 "
        "and x3: `frame: u1 0.2*x1 u3 0.2*x3`. Unit: mm.",
        Map(Anything(), Anything(), 0, 100));
  }
  plates.declare(prm);
  const Section section(prm, {"Temperature"});
  add_quantity(prm, "Fixed", temperatures,
               "Temperatures of surfaces, as `inner: 353`; only for a temperature field.",
               Quantity("K", 1.));
}

template <int dim>
void BoundaryConditions<dim>::setup(const Mesh<dim>& mesh, const FieldLayout<dim>& layout)
{
  Complaints complaints;
  complaints.allow([&]() { fix_supports(mesh, layout); });
  complaints.allow([&]() { fix_moved_supports(mesh, layout); });
  complaints.allow([&]() { plates.setup(mesh, layout); });
  complaints.allow([&]() { fix_temperatures(mesh, layout); });
  complaints.raise();
  collect_driven();

  owned = layout.dof_handler().locally_owned_dofs();
  homogeneous.clear();
  for (const Values* values : {&fixed_dofs, &moved_dofs, &heated_dofs})
    for (const auto& entry : *values)
      homogeneous.add_line(entry.first);
  for (const Electrode& electrode : electrodes())
    for (const auto dof : electrode.dofs)
      homogeneous.add_line(dof);
  for (const auto& pair : layout.duplicates())
    homogeneous.add_line(pair.first);
  homogeneous.close();
}

template <int dim>
void BoundaryConditions<dim>::fix(const Mesh<dim>& mesh, const FieldLayout<dim>& layout,
                                  const std::string& surface, const std::string& place,
                                  const unsigned int component, const Value& value, Values& values)
{
  for (const auto& [dof, X] : placed_dofs_on(mesh, layout, surface, place, component))
    if (std::abs(values.emplace(dof, value(X)).first->second - value(X)) > 1e-12)
      throw InputError(place + ": surface '" + surface +
                       "' touches another one with a different value; prescribe one value at each "
                       "point");
}

template <int dim>
void BoundaryConditions<dim>::fix_supports(const Mesh<dim>& mesh, const FieldLayout<dim>& layout)
{
  const std::string place = "section Supports, entry 'Fixed'";
  Complaints complaints;
  for (const auto& [surface, components] : supports)
    complaints.allow([&, &surface = surface, &components = components]() {
      for (const unsigned int c : components_named<dim>(components, place))
        fix(
            mesh, layout, surface, place, c, [](const auto&) { return 0.; }, fixed_dofs);
    });
  if (supports.empty())
    complaints.add(place + ": the body is free to move; fix enough components to hold it");
  complaints.raise();
}

template <int dim>
void BoundaryConditions<dim>::require_held(const Mesh<dim>& mesh) const
{
  RigidMotions<dim> motions(mesh);
  for (const auto& [surface, components] : supports)
    for (const unsigned int c : components_named<dim>(components, ""))
      motions.hold(surface, c);
  for (const auto& [surface, text] : moved_supports)
    for (const auto& part : moved_components(text, ""))
      motions.hold(surface, components_named<dim>(part.first, "").front());
  Complaints complaints;
  for (const std::string& sentence : motions.remaining())
    complaints.add("section Supports, entry 'Fixed': " + sentence);
  complaints.raise();
}

template <int dim>
void BoundaryConditions<dim>::fix_moved_supports(const Mesh<dim>& mesh,
                                                 const FieldLayout<dim>& layout)
{
  const std::string place = "section Supports, entry 'Moved'";
  for (const auto& [surface, text] : moved_supports)
    for (const auto& [name, way_text] : moved_components(text, place)) {
      const auto way = moved_way<dim>(way_text, place);
      for (const unsigned int c : components_named<dim>(name, place))
        fix(mesh, layout, surface, place, c, way, moved_dofs);
    }
  for (const auto& entry : moved_dofs)
    fixed_dofs.erase(entry.first);
}

template <int dim>
void BoundaryConditions<dim>::collect_driven()
{
  driven_dofs.clear();
  for (const Electrode& electrode : electrodes())
    if (!electrode.floats)
      for (const auto dof : electrode.dofs)
        driven_dofs[dof] = electrode.voltage_multiple;
}

template <int dim>
void BoundaryConditions<dim>::disconnect(const std::string& name, const double charge)
{
  plates.disconnect(name, charge);
  collect_driven();
}

template <int dim>
void BoundaryConditions<dim>::connect(const std::string& name)
{
  plates.connect(name);
  collect_driven();
}

template <int dim>
void BoundaryConditions<dim>::fix_temperatures(const Mesh<dim>& mesh,
                                               const FieldLayout<dim>& layout)
{
  const std::string place = "section Temperature, entry 'Fixed'";
  if (!layout.has(Field::temperature) && !temperatures.empty())
    throw InputError(place + ": a uniform temperature is set by 'Value'; remove this entry or "
                             "choose Model = steady");
  for (const auto& [surface, theta] : temperatures)
    fix(
        mesh, layout, surface, place, layout.first_component(Field::temperature),
        [theta = theta](const auto&) { return theta; }, heated_dofs);
}

template <int dim>
void BoundaryConditions<dim>::apply(const double voltage, const double theta_start,
                                    const double heating, BlockVector& x) const
{
  for (const auto& [dof, value] : fixed_dofs)
    if (owned.is_element(dof))
      x(dof) = value;
  for (const auto& [dof, way] : moved_dofs)
    if (owned.is_element(dof))
      x(dof) = motion * way;
  for (const auto& [dof, factor] : driven_dofs)
    if (owned.is_element(dof))
      x(dof) = factor * voltage;
  for (const auto& [dof, theta] : heated_dofs)
    if (owned.is_element(dof))
      x(dof) = theta_start + heating * (theta - theta_start);
  x.update_ghost_values();
}

template <int dim>
dealii::types::global_dof_index BoundaryConditions<dim>::n_free(const FieldLayout<dim>& layout,
                                                                const Field field) const
{
  dealii::types::global_dof_index begin = 0;
  for (unsigned int b = 0; b < layout.block(field); ++b)
    begin += layout.owned()[b].size();
  const dealii::types::global_dof_index end = begin + layout.owned()[layout.block(field)].size();
  dealii::types::global_dof_index constrained = 0;
  for (const auto& line : homogeneous.get_lines())
    constrained += line.index >= begin && line.index < end;
  return end - begin - constrained;
}

template class BoundaryConditions<2>;
template class BoundaryConditions<3>;

} // namespace thelma
