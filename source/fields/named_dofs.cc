#include <thelma/base/axes.h>
#include <thelma/base/error.h>
#include <thelma/fields/named_dofs.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// Whether the point @p p of the reference cell lies on the face, line or vertex that the local
/// vertices in @p mask span.
template <int dim>
bool lies_on(const dealii::Point<dim>& p, const std::uint8_t mask)
{
  for (unsigned int d = 0; d < dim; ++d) {
    bool low = true, high = true;
    for (unsigned int v = 0; v < dealii::GeometryInfo<dim>::vertices_per_cell; ++v)
      if (mask & (1u << v)) {
        low = low && !(v & (1u << d));
        high = high && (v & (1u << d));
      }
    if ((low && p[d] > 1e-10) || (high && p[d] < 1. - 1e-10))
      return false;
  }
  return true;
}

} // namespace

template <int dim>
std::set<dealii::types::global_dof_index>
dofs_on(const Mesh<dim>& mesh, const DofLayout<dim>& layout, const std::string& surface,
        const std::string& place, const unsigned int component)
{
  const auto& points = layout.scalar_element().get_unit_support_points();
  std::vector<dealii::types::global_dof_index> indices;
  std::set<dealii::types::global_dof_index> dofs;
  for (const auto& [entity, vertices] : mesh.surface(surface, place)) {
    const auto cell = layout.with_unknowns(entity);
    layout.unknowns(cell, indices);
    for (unsigned int a = 0; a < points.size(); ++a)
      if (lies_on<dim>(points[a], vertices))
        if (const auto i = layout.local_dof(cell->active_fe_index(), a, component))
          dofs.insert(indices[*i]);
  }
  return dealii::Utilities::MPI::compute_set_union(dofs, layout.communicator());
}

template <int dim>
void require_off_axis(const Mesh<dim>& mesh, const std::string& surface, const std::string& place)
{
  if (!mesh.cross_section().is_axisymmetric())
    return;
  bool is_off = false;
  for (const auto& [cell, vertices] : mesh.surface(surface, place))
    for (const unsigned int v : cell->vertex_indices())
      is_off |= (vertices & (1u << v)) && cell->vertex(v)[0] > 1e-9 * cell->diameter();
  if (!dealii::Utilities::MPI::logical_or(is_off, mesh.communicator()))
    throw InputError(
        place + ": '" + surface +
        "' lies on the axis of the body, where neither charge nor heat gets in because "
        "it has no area; remove it, or name another surface");
}

double sum_over(const std::set<dealii::types::global_dof_index>& dofs, const BlockVector& x)
{
  const auto owned = x.locally_owned_elements();
  double sum = 0.;
  for (const auto dof : dofs)
    if (owned.is_element(dof))
      sum += x(dof);
  return dealii::Utilities::MPI::sum(sum, x.block(0).get_mpi_communicator());
}

template <int dim>
std::vector<unsigned int> components_named(const std::string& text)
{
  std::vector<std::string> known;
  for (int d = 0; d < dim; ++d)
    known.push_back(component_name<dim>(d));
  const auto require = [&](const bool is_known, const std::string& word) {
    if (!is_known)
      throw InputError("'" + word + "' is no displacement component; write any of " +
                       comma_separated(known) + " with blanks between");
  };
  std::vector<unsigned int> components;
  for (const std::string& word : dealii::Utilities::split_string_list(text, ' ')) {
    const auto found = std::find(known.begin(), known.end(), word);
    require(found != known.end(), word);
    components.push_back(found - known.begin());
  }
  require(!components.empty(), text);
  return components;
}

template std::vector<unsigned int> components_named<2>(const std::string&);
template std::vector<unsigned int> components_named<3>(const std::string&);
template std::set<dealii::types::global_dof_index>
dofs_on(const Mesh<2>&, const DofLayout<2>&, const std::string&, const std::string&, unsigned int);
template std::set<dealii::types::global_dof_index>
dofs_on(const Mesh<3>&, const DofLayout<3>&, const std::string&, const std::string&, unsigned int);
template void require_off_axis(const Mesh<2>&, const std::string&, const std::string&);
template void require_off_axis(const Mesh<3>&, const std::string&, const std::string&);

} // namespace thelma
