#include <thelma/assembly/system.h>

#include <deal.II/base/mpi.h>

namespace thelma
{

template <int dim>
void System<dim>::clear_given(BlockVector& x) const
{
  for (const Field field : layout.fields())
    if (!solves(field))
      x.block(layout.block(field)) = 0.;
}

/// A wrong temperature is as bad where it is stored as where it is conducted.
template <int dim>
double System<dim>::scale(const unsigned int block) const
{
  const bool temperature =
      layout.has(Field::temperature) && block == layout.block(Field::temperature);
  const double size = scales[block] + (temperature ? storage.storage_scale(state) : 0.);
  return size > 0. ? size : 1.; // where all is given
}

template <int dim>
HeatInflow System<dim>::heat_inflow() const
{
  const auto owned = layout.dof_handler().locally_owned_dofs();
  std::vector<double> own{0., 0.}, sum(2);
  for (const auto& [unknown, theta] : conditions.heated())
    if (owned.is_element(unknown)) {
      own[0] += raw_residual(unknown);
      own[1] += raw_residual(unknown) / state.x(unknown);
    }
  dealii::Utilities::MPI::sum(own, layout.communicator(), sum);
  const HeatInflow loaded = loads.heat_inflow(layout, state), stored = storage.wall_inflow(state);
  return {sum[0] + loaded.heat + stored.heat, sum[1] + loaded.entropy + stored.entropy};
}

template <int dim>
Energies System<dim>::energies() const
{
  Energies sum;
  for_each_cell([&](const CellView<dim>& view) { sum.add(1., formulation->energies(view)); });
  return sum;
}

template void System<2>::clear_given(BlockVector&) const;
template void System<3>::clear_given(BlockVector&) const;
template double System<2>::scale(unsigned int) const;
template double System<3>::scale(unsigned int) const;
template HeatInflow System<2>::heat_inflow() const;
template HeatInflow System<3>::heat_inflow() const;
template Energies System<2>::energies() const;
template Energies System<3>::energies() const;

} // namespace thelma
