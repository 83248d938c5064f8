#include <thelma/fields/duplicates.h>

#include <deal.II/dofs/dof_accessor.h>

namespace thelma
{

template <int dim>
std::map<dealii::types::global_dof_index, dealii::types::global_dof_index>
duplicate_dofs(const dealii::DoFHandler<dim>& dofs, const unsigned int degree,
               const unsigned int absent)
{
  std::map<dealii::types::global_dof_index, dealii::types::global_dof_index> duplicates;
  if constexpr (dim == 3) {
    const unsigned int n_inner = degree - 1; // nodes of a component on a line, apart from its ends
    for (const auto& cell : dofs.active_cell_iterators())
      for (unsigned int l = 0; cell->active_fe_index() == 1 && l < cell->n_lines(); ++l) {
        const auto line = cell->line(l);
        if (!line->fe_index_is_active(0))
          continue;
        for (unsigned int i = 0; i < cell->get_fe().n_dofs_per_line(); ++i) {
          const unsigned int original = i < absent * n_inner ? i : i + n_inner;
          const auto here = line->dof_index(i, 1), there = line->dof_index(original, 0);
          if (here != there)
            duplicates[here] = there;
        }
      }
  }
  return duplicates;
}

template std::map<dealii::types::global_dof_index, dealii::types::global_dof_index>
duplicate_dofs(const dealii::DoFHandler<2>&, unsigned int, unsigned int);
template std::map<dealii::types::global_dof_index, dealii::types::global_dof_index>
duplicate_dofs(const dealii::DoFHandler<3>&, unsigned int, unsigned int);

} // namespace thelma
