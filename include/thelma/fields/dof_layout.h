#pragma once

#include <thelma/fields/field_set.h>
#include <thelma/materials/library.h>
#include <thelma/mesh/mesh.h>

#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/hp/fe_collection.h>
#include <deal.II/lac/la_parallel_block_vector.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace thelma
{

using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

/// One locally owned cell as the element formulations need it. Local degrees of freedom are
/// ordered node by node: (u_1 .. u_dim, phi, theta) of node 0, of node 1, ...
template <int dim>
struct Cell {
  typename dealii::DoFHandler<dim>::active_cell_iterator iterator;
  const Material* material;
  unsigned int n_components; ///< fields on this cell, counted by components
  bool has_potential;
  std::array<unsigned int, n_field_kinds> components; ///< first one of each field that is here
  std::vector<dealii::types::global_dof_index> dofs;
  std::vector<unsigned int> local; ///< the same within this rank's part of their block

  /// The (first) component of @p field, which is here.
  unsigned int component(const Field field) const
  {
    return components[static_cast<std::size_t>(field)];
  }

  /// Where that stands in `dofs` at the node @p a.
  std::size_t unknown(const unsigned int a, const Field field) const
  {
    return std::size_t(a) * n_components + component(field);
  }

  Field field_of(const unsigned int c) const
  {
    return c < dim                                             ? Field::displacement
           : has_potential && c == component(Field::potential) ? Field::potential
                                                               : Field::temperature;
  }
};

/// Which field lives where, and the numbering: displacement everywhere, potential only in regions
/// that carry a field, temperature only where it is solved for.
template <int dim>
class DofLayout : public FieldSet<dim>, public CrossSection<dim>
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Distribute the degrees of freedom of @p mesh; a component with no unknowns is left out.
  void setup(const Mesh<dim>& mesh, const MaterialLibrary& materials);

  unsigned int block_of_dof(dealii::types::global_dof_index dof) const;

  const dealii::DoFHandler<dim>& dof_handler() const { return dofs; }
  const std::vector<Cell<dim>>& cells() const { return own_cells; }
  const dealii::FE_Q<dim>& scalar_element() const { return *scalar; }
  unsigned int degree() const { return polynomial_degree; }

  /// From the reference cell to the undeformed body.
  const dealii::Mapping<dim>& mapping() const { return *cell_mapping; }
  MPI_Comm communicator() const { return dofs.get_communicator(); }

  /// One index set per block.
  const std::vector<dealii::IndexSet>& owned() const { return owned_dofs; }
  const std::vector<dealii::IndexSet>& relevant() const { return relevant_dofs; }
  dealii::types::global_dof_index n_dofs(Field field) const;

  /// Entries of the vectors that are not used, with the unknown that stands for them: all that this
  /// rank's cells have.
  const std::map<dealii::types::global_dof_index, dealii::types::global_dof_index>&
  duplicates() const
  {
    return stand_ins;
  }

  /// A cell of the mesh as one with unknowns.
  typename dealii::DoFHandler<dim>::active_cell_iterator
  with_unknowns(const typename Mesh<dim>::CellIterator& cell) const
  {
    return {&dofs.get_triangulation(), cell->level(), cell->index(), &dofs};
  }

  /// The unknowns of a cell in the order of its element.
  void unknowns(const typename dealii::DoFHandler<dim>::active_cell_iterator& cell,
                std::vector<dealii::types::global_dof_index>& indices) const;

  /// Give the unused owned entries of @p x the values that stand for them, for whoever reads the
  /// DoFHandler.
  void complete(BlockVector& x) const;

  /// A zero vector whose ghost entries are those of this rank's cells.
  BlockVector new_vector() const;

  /// Values of @p x (with ghosts) at the unknowns of @p cell.
  void gather(const Cell<dim>& cell, const BlockVector& x, std::vector<double>& values) const;

  /// Add @p values to the entries of @p x, own or ghost; compress(add) comes later.
  void scatter(const Cell<dim>& cell, const std::vector<double>& values, BlockVector& x) const;

  /// Local index of component @p c of node @p a of an @p fe_index cell, or nothing if absent.
  std::optional<unsigned int> local_dof(unsigned int fe_index, unsigned int a,
                                        unsigned int c) const;

  /// What is solved for and what is left out, one line each.
  std::vector<std::string> summary() const;

private:
  void build_elements();
  void number_blockwise();
  template <typename Visitor>
  void for_each_unknown(const Cell<dim>& cell, const Visitor& visit) const;
  void collect_cells(const Mesh<dim>& mesh, const MaterialLibrary& materials);

  unsigned int polynomial_degree = 1;
  std::vector<std::string> passive_regions;

  std::unique_ptr<dealii::FE_Q<dim>> scalar;
  std::unique_ptr<dealii::Mapping<dim>> cell_mapping;
  dealii::hp::FECollection<dim> elements; ///< 0: every field; 1: no potential
  dealii::DoFHandler<dim> dofs;
  std::vector<std::vector<int>> position; ///< [fe_index][a * n_components + c], -1 if absent
  std::map<dealii::types::global_dof_index, dealii::types::global_dof_index> stand_ins;
  std::vector<unsigned long long> n_duplicates; ///< of each block, on all ranks
  std::vector<dealii::IndexSet> owned_dofs, relevant_dofs;
  std::vector<Cell<dim>> own_cells;
};

} // namespace thelma
