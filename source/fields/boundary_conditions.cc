#include <thelma/base/error.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/named_dofs.h>
#include <thelma/fields/rigid_motions.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <set>

namespace thelma
{
namespace
{

/// `u1 2.5`: the component and its way in mm.
template <int dim>
std::pair<unsigned int, double> parse_move(const std::string& text)
{
  const std::size_t blank = text.find(' ');
  if (blank == std::string::npos)
    throw InputError("'" + text + "' is not a displacement component and mm; write it as u1 2.5");
  return {components_named<dim>(text.substr(0, blank)).front(),
          Quantity("mm").value(text.substr(blank))};
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
    check_values(prm, "Fixed", [](const std::string& text) { components_named<dim>(text); });
    prm.add_parameter("Moved", moved_supports,
                      "A displacement component of each surface, line or point and where the "
                      "stage `move` (Loading/Stages) takes it, as `grip: u1 2.5`. Unit: mm.",
                      Map(Anything(), Anything(), 0, 100));
    check_values(prm, "Moved", [](const std::string& text) { parse_move<dim>(text); });
  }
  electrode_set.declare(prm);
  const Section section(prm, {"Temperature"});
  add_quantity(prm, "Fixed", temperatures,
               "Temperatures of surfaces, as `inner: 353`; only for a temperature field.",
               Quantity("K", 1., 1e4));
}

template <int dim>
void BoundaryConditions<dim>::setup(const Mesh<dim>& mesh, const DofLayout<dim>& layout)
{
  InputErrors errors;
  const bool has_supports = errors.collect([&]() { fix_supports(mesh, layout); });
  if (errors.collect([&]() { fix_moved_supports(mesh, layout); }) && has_supports)
    errors.collect([&]() { require_held(mesh); });
  errors.collect([&]() { fix_axis(layout); });
  errors.collect([&]() { electrode_set.setup(mesh, layout); });
  errors.collect([&]() { fix_temperatures(mesh, layout); });
  errors.raise();
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
void BoundaryConditions<dim>::fix(const Mesh<dim>& mesh, const DofLayout<dim>& layout,
                                  const std::string& surface, const std::string& place,
                                  const unsigned int component, const double value, Values& values)
{
  for (const auto dof : dofs_on(mesh, layout, surface, place, component))
    if (values.emplace(dof, value).first->second != value)
      throw InputError(place + ": surface '" + surface +
                       "' touches another one with a different value; prescribe one value at each "
                       "point");
}

template <int dim>
void BoundaryConditions<dim>::fix_supports(const Mesh<dim>& mesh, const DofLayout<dim>& layout)
{
  const std::string place = "section Supports, entry 'Fixed'";
  InputErrors errors;
  for (const auto& [surface, components] : supports)
    errors.collect([&, &surface = surface, &components = components]() {
      for (const unsigned int c : components_named<dim>(components))
        fix(mesh, layout, surface, place, c, 0., fixed_dofs);
    });
  if (supports.empty())
    errors.add(place + ": the body is free to move; fix enough components to hold it");
  errors.raise();
}

template <int dim>
void BoundaryConditions<dim>::require_held(const Mesh<dim>& mesh) const
{
  RigidMotions<dim> motions(mesh);
  for (const auto& [surface, components] : supports)
    for (const unsigned int c : components_named<dim>(components))
      motions.hold(surface, c);
  for (const auto& [surface, text] : moved_supports)
    motions.hold(surface, parse_move<dim>(text).first);
  InputErrors errors;
  for (const std::string& sentence : motions.remaining())
    errors.add("section Supports, entry 'Fixed': " + sentence);
  errors.raise();
}

template <int dim>
void BoundaryConditions<dim>::fix_moved_supports(const Mesh<dim>& mesh,
                                                 const DofLayout<dim>& layout)
{
  const std::string place = "section Supports, entry 'Moved'";
  for (const auto& [surface, text] : moved_supports) {
    const auto [component, way] = parse_move<dim>(text);
    if (const auto held = supports.find(surface); held != supports.end())
      for (const unsigned int c : components_named<dim>(held->second))
        if (c == component)
          throw InputError(place + ": the entry 'Fixed' holds the same component of '" + surface +
                           "'; leave it out there");
    fix(mesh, layout, surface, place, component, way, moved_dofs);
  }
  for (const auto& entry : moved_dofs)
    fixed_dofs.erase(entry.first);
}

/// The points of a body of revolution that lie on its axis stay there.
template <int dim>
void BoundaryConditions<dim>::fix_axis(const DofLayout<dim>& layout)
{
  if (!layout.is_axisymmetric())
    return;
  const auto& points = layout.scalar_element().get_unit_support_points();
  std::set<dealii::types::global_dof_index> axis;
  for (const Cell<dim>& cell : layout.cells())
    for (unsigned int a = 0; a < points.size(); ++a)
      if (layout.mapping().transform_unit_to_real_cell(cell.iterator, points[a])[0] <
          1e-9 * cell.iterator->diameter())
        axis.insert(cell.dofs[cell.unknown(a, Field::displacement)]);
  for (const auto dof : dealii::Utilities::MPI::compute_set_union(axis, layout.communicator())) {
    const auto moved = moved_dofs.find(dof);
    if (moved != moved_dofs.end() && moved->second != 0.)
      throw InputError("section Supports, entry 'Moved': u1 of a point on the axis x1 = 0 cannot "
                       "change; move only points beside it, or other components");
    fixed_dofs[dof] = 0.;
  }
}

template <int dim>
std::vector<std::string> BoundaryConditions<dim>::holding(const unsigned int component) const
{
  std::vector<std::string> names;
  for (const auto& [name, text] : supports) {
    const std::vector<unsigned int> held = components_named<dim>(text);
    if (std::find(held.begin(), held.end(), component) != held.end())
      names.push_back(name);
  }
  for (const auto& [name, text] : moved_supports)
    if (parse_move<dim>(text).first == component)
      names.push_back(name);
  return names;
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
  electrode_set.disconnect(name, charge);
  collect_driven();
}

template <int dim>
void BoundaryConditions<dim>::connect(const std::string& name)
{
  electrode_set.connect(name);
  collect_driven();
}

template <int dim>
void BoundaryConditions<dim>::fix_temperatures(const Mesh<dim>& mesh, const DofLayout<dim>& layout)
{
  const std::string place = "section Temperature, entry 'Fixed'";
  if (!layout.has(Field::temperature) && !temperatures.empty())
    throw InputError(place + ": a uniform temperature is set by 'Value'; remove this entry or "
                             "choose Model = steady");
  for (const auto& [surface, theta] : temperatures) {
    require_off_axis(mesh, surface, place);
    fix(mesh, layout, surface, place, layout[Field::temperature].component, theta, heated_dofs);
  }
}

template <int dim>
void BoundaryConditions<dim>::hold_supports(BlockVector& x) const
{
  for (const auto& [dof, value] : fixed_dofs)
    if (owned.is_element(dof))
      x(dof) = value;
}

template <int dim>
dealii::types::global_dof_index BoundaryConditions<dim>::n_free(const DofLayout<dim>& layout,
                                                                const Field field) const
{
  dealii::types::global_dof_index begin = 0;
  for (unsigned int b = 0; b < layout.block(field); ++b)
    begin += layout.owned()[b].size();
  const dealii::types::global_dof_index end = begin + layout.owned()[layout.block(field)].size();
  dealii::types::global_dof_index constrained = 0;
  for (const auto& line : homogeneous.get_lines())
    constrained += owned.is_element(line.index) && line.index >= begin && line.index < end;
  return end - begin - dealii::Utilities::MPI::sum(constrained, layout.communicator());
}

template class BoundaryConditions<2>;
template class BoundaryConditions<3>;

} // namespace thelma
