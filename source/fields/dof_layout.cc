#include <thelma/base/error.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/parameters.h>
#include <thelma/fields/dof_layout.h>
#include <thelma/fields/duplicates.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_system.h>

#include <algorithm>

namespace thelma
{

template <int dim>
void DofLayout<dim>::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  {
    const Section section(prm, {"Discretisation"});
    prm.add_parameter("Degree", polynomial_degree, "Polynomial degree p of every field.",
                      Integer(1, 2));
  }
  {
    const Section section(prm, {"Regions"});
    prm.add_parameter("Passive", passive_regions,
                      "Regions that carry no electric field; the potential is not solved there.",
                      List(Anything(), 0, 100));
  }
  FieldSet<dim>::declare(prm);
}

template <int dim>
void DofLayout<dim>::setup(const Mesh<dim>& mesh, const MaterialLibrary& materials)
{
  const std::vector<std::string>& regions = mesh.regions();
  InputErrors errors;
  const auto require_regions = [&](const std::string& entry, const auto& names) {
    for (const std::string& name : names)
      errors.collect(
          [&]() { require_region(mesh, name, "section Regions, entry '" + entry + "'"); });
  };
  require_regions("Passive", passive_regions);
  require_regions("Materials", materials.regions());
  errors.raise(); // a region whose name is misspelt has no material
  for (const std::string& name : regions)
    errors.collect([&]() { materials.of_region(name); });
  errors.raise();

  const auto is_passive = [&](const std::string& region) {
    return std::find(passive_regions.begin(), passive_regions.end(), region) !=
           passive_regions.end();
  };
  this->choose_fields(!std::all_of(regions.begin(), regions.end(), is_passive));

  static_cast<CrossSection<dim>&>(*this) = mesh.cross_section();
  build_elements();
  cell_mapping = mesh.mapping(polynomial_degree);
  dofs.reinit(mesh.triangulation());
  for (const auto& cell : dofs.active_cell_iterators())
    if (cell->is_locally_owned())
      cell->set_active_fe_index(
          this->has(Field::potential) && is_passive(mesh.region_of(cell)) ? 1 : 0);
  dofs.distribute_dofs(elements);
  number_blockwise();
  collect_cells(mesh, materials);
}

template <int dim>
void DofLayout<dim>::build_elements()
{
  scalar = std::make_unique<dealii::FE_Q<dim>>(polynomial_degree);
  const dealii::FE_Nothing<dim> nothing;
  for (const bool with_potential : {true, false}) {
    if (!with_potential && !this->has(Field::potential))
      break;
    std::vector<const dealii::FiniteElement<dim>*> bases;
    for (const Field field : this->fields()) {
      const bool absent = field == Field::potential && !with_potential;
      const dealii::FiniteElement<dim>* base = scalar.get();
      bases.insert(bases.end(), (*this)[field].n_components, absent ? &nothing : base);
    }
    elements.push_back(dealii::FESystem<dim>(bases, std::vector<unsigned int>(bases.size(), 1)));

    const dealii::FiniteElement<dim>& fe = elements[elements.size() - 1];
    position.emplace_back(scalar->dofs_per_cell * this->n_components(), -1);
    for (unsigned int i = 0; i < fe.dofs_per_cell; ++i) {
      const auto [c, a] = fe.system_to_component_index(i);
      position.back()[a * this->n_components() + c] = static_cast<int>(i);
    }
  }
}

template <int dim>
void DofLayout<dim>::number_blockwise()
{
  std::vector<unsigned int> block_of;
  for (const Field field : this->fields())
    block_of.insert(block_of.end(), (*this)[field].n_components, this->block(field));
  dealii::DoFRenumbering::component_wise(dofs, block_of);

  const auto sizes = dealii::DoFTools::count_dofs_per_fe_block(dofs, block_of);
  const dealii::IndexSet owned = dofs.locally_owned_dofs();
  dealii::IndexSet active = dealii::DoFTools::extract_locally_active_dofs(dofs);
  if (elements.size() > 1)
    stand_ins = duplicate_dofs(dofs, polynomial_degree, (*this)[Field::potential].component);
  for (const auto& [duplicate, original] : stand_ins)
    if (active.is_element(duplicate))
      active.add_index(original);
  dealii::types::global_dof_index begin = 0;
  for (const auto size : sizes) {
    owned_dofs.push_back(owned.get_view(begin, begin + size));
    relevant_dofs.push_back(active.get_view(begin, begin + size));
    begin += size;
  }
  n_duplicates.assign(sizes.size(), 0);
  for (const auto& pair : stand_ins)
    n_duplicates[block_of_dof(pair.first)] += owned.is_element(pair.first);
  dealii::Utilities::MPI::sum(n_duplicates, communicator(), n_duplicates);
}

template <int dim>
void DofLayout<dim>::collect_cells(const Mesh<dim>& mesh, const MaterialLibrary& materials)
{
  const BlockVector example = new_vector();
  const auto& indices_of_blocks = example.get_block_indices();
  std::vector<dealii::types::global_dof_index> indices;
  for (const auto& iterator : dofs.active_cell_iterators())
    if (iterator->is_locally_owned()) {
      Cell<dim> cell;
      const unsigned int fe_index = iterator->active_fe_index();
      cell.iterator = iterator;
      cell.material = &materials.of_region(mesh.region_of(iterator));
      cell.has_potential = this->has(Field::potential) && fe_index == 0;
      unknowns(iterator, indices);
      for (const int i : position[fe_index])
        if (i >= 0)
          cell.dofs.push_back(indices[i]);
      cell.n_components = 0;
      for (const Field field : this->fields())
        if (field != Field::potential || cell.has_potential) {
          cell.components[static_cast<std::size_t>(field)] = cell.n_components;
          cell.n_components += (*this)[field].n_components;
        }
      for (const auto dof : cell.dofs) {
        const auto [block, index] = indices_of_blocks.global_to_local(dof);
        cell.local.push_back(example.block(block).get_partitioner()->global_to_local(index));
      }
      own_cells.push_back(std::move(cell));
    }
}

template <int dim>
void DofLayout<dim>::unknowns(const typename dealii::DoFHandler<dim>::active_cell_iterator& cell,
                              std::vector<dealii::types::global_dof_index>& indices) const
{
  indices.resize(cell->get_fe().dofs_per_cell);
  cell->get_dof_indices(indices);
  for (auto& index : indices)
    if (const auto found = stand_ins.find(index); found != stand_ins.end())
      index = found->second;
}

template <int dim>
void DofLayout<dim>::complete(BlockVector& x) const
{
  const dealii::IndexSet owned = dofs.locally_owned_dofs();
  for (const auto& [duplicate, original] : stand_ins)
    if (owned.is_element(duplicate))
      x(duplicate) = x(original);
  x.update_ghost_values();
}

template <int dim>
dealii::types::global_dof_index DofLayout<dim>::n_dofs(const Field field) const
{
  const unsigned int b = this->block(field);
  return owned_dofs[b].size() - n_duplicates[b];
}

template <int dim>
unsigned int DofLayout<dim>::block_of_dof(dealii::types::global_dof_index dof) const
{
  unsigned int b = 0;
  for (; dof >= owned_dofs[b].size(); ++b)
    dof -= owned_dofs[b].size();
  return b;
}

template <int dim>
BlockVector DofLayout<dim>::new_vector() const
{
  return BlockVector(owned_dofs, relevant_dofs, communicator());
}

/// Call @p visit(block, place in Cell::dofs) for the unknowns of @p cell, field by field.
template <int dim>
template <typename Visitor>
void DofLayout<dim>::for_each_unknown(const Cell<dim>& cell, const Visitor& visit) const
{
  for (const Field field : this->fields()) {
    if (field == Field::potential && !cell.has_potential)
      continue;
    const FieldPlace& place = (*this)[field];
    const unsigned int first = cell.unknown(0, field);
    for (unsigned int c = first; c < first + place.n_components; ++c)
      for (std::size_t i = c; i < cell.dofs.size(); i += cell.n_components)
        visit(place.block, i);
  }
}

template <int dim>
void DofLayout<dim>::gather(const Cell<dim>& cell, const BlockVector& x,
                            std::vector<double>& values) const
{
  values.resize(cell.dofs.size());
  for_each_unknown(cell, [&](const unsigned int block, const std::size_t i) {
    values[i] = x.block(block).local_element(cell.local[i]);
  });
}

template <int dim>
void DofLayout<dim>::scatter(const Cell<dim>& cell, const std::vector<double>& values,
                             BlockVector& x) const
{
  for_each_unknown(cell, [&](const unsigned int block, const std::size_t i) {
    x.block(block).local_element(cell.local[i]) += values[i];
  });
}

template <int dim>
std::optional<unsigned int> DofLayout<dim>::local_dof(const unsigned int fe_index,
                                                      const unsigned int a,
                                                      const unsigned int c) const
{
  const int i = position[fe_index][a * this->n_components() + c];
  return i < 0 ? std::nullopt : std::optional<unsigned int>(i);
}

template <int dim>
std::vector<std::string> DofLayout<dim>::summary() const
{
  std::vector<std::string> lines;
  std::string solved;
  for (const Field field : this->fields())
    solved += (solved.empty() ? "" : ", ") + field_name(field) + " (" +
              std::to_string(n_dofs(field)) + " unknowns)";
  lines.push_back("solved for: " + solved + ", degree " + std::to_string(polynomial_degree) +
                  (this->is_axisymmetric() ? ", axisymmetric about x1 = 0, where u1 = 0"
                   : dim == 2              ? ", plane strain"
                                           : ""));
  if (!this->has(Field::potential))
    lines.emplace_back("left out: potential, because every region is passive");
  else if (!passive_regions.empty())
    lines.push_back("left out: potential in " + comma_separated(passive_regions) +
                    ", because Regions/Passive says so");
  if (!this->has(Field::temperature))
    lines.emplace_back("left out: temperature field, because Temperature/Model is uniform");
  return lines;
}

template class DofLayout<2>;
template class DofLayout<3>;

} // namespace thelma
