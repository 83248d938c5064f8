#include <thelma/assembly/heat_storage.h>
#include <thelma/fields/nodal_quadrature.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace thelma
{

template <int dim>
void HeatStorage<dim>::setup(const DofLayout<dim>& layout,
                             const BoundaryConditions<dim>& conditions)
{
  exists = layout.has(Field::temperature);
  if (!exists)
    return;
  block = layout.block(Field::temperature);
  capacities = layout.new_vector();
  const auto capacity = [](const Cell<dim>& cell) -> Density<dim> {
    return [c = cell.material->thermal.c](unsigned int, const dealii::Point<dim>&) { return c; };
  };
  add_integrals<dim>(layout, nodal_rule<dim>(layout), Field::temperature, capacity, capacities);
  capacities.compress(dealii::VectorOperation::add);
  const auto begin = capacities.get_block_indices().block_start(block);
  const auto& nodes = *capacities.block(block).get_partitioner();
  walls.clear();
  for (const auto& entry : conditions.heated())
    if (nodes.in_local_range(entry.first - begin))
      walls.push_back(nodes.global_to_local(entry.first - begin));
}

template <int dim>
void HeatStorage<dim>::add_residual(const State& state, BlockVector& residual) const
{
  if (!exists || !state.rates)
    return;
  auto& r = residual.block(block);
  for (unsigned int i = 0; i < r.locally_owned_size(); ++i)
    r.local_element(i) += storage(state, i);
}

/// What a node stores, in mW.
template <int dim>
double HeatStorage<dim>::storage(const State& state, const unsigned int i) const
{
  if (!state.rates)
    return 0.;
  const auto& path = state.path();
  const auto past = [&](const std::size_t k) {
    return path[path.size() - 1 - k].x.block(block).local_element(i);
  };
  const double now = state.x.block(block).local_element(i);
  const double rate =
      state.rates->heat == StructuralHeat::entropy
          ? now * state.rates->of(
                      0., [&](const std::size_t k) { return std::log1p((past(k) - now) / now); })
          : state.rates->of(now, past);
  return capacities.block(block).local_element(i) * rate;
}

template <int dim>
void HeatStorage<dim>::add_tangent(const State& state, TangentEntries<dim>& tangent) const
{
  if (!exists || !state.rates)
    return;
  const auto begin = capacities.get_block_indices().block_start(block);
  const auto& theta = state.x.block(block);
  const auto& path = state.path();
  for (const auto i : theta.locally_owned_elements()) {
    double rate = state.rates->weights[0];
    if (state.rates->heat == StructuralHeat::entropy)
      rate += state.rates->of(0., [&](const std::size_t k) {
        return std::log(path[path.size() - 1 - k].x.block(block)(i) / theta(i));
      });
    tangent.add_diagonal(begin + i, rate * capacities.block(block)(i));
  }
}

template <int dim>
double HeatStorage<dim>::storage_scale(const State& state) const
{
  return state.rates ? state.rates->weights[0] * capacities.block(block).l2_norm() : 0.;
}

template <int dim>
HeatInflow HeatStorage<dim>::wall_inflow(const State& state) const
{
  const auto& theta = state.x.block(block);
  std::vector<double> own{0., 0.}, sum(2);
  for (const unsigned int i : walls) {
    own[0] -= storage(state, i);
    own[1] -= storage(state, i) / theta.local_element(i);
  }
  dealii::Utilities::MPI::sum(own, theta.get_mpi_communicator(), sum);
  return {sum[0], sum[1]};
}

template <int dim>
Energies HeatStorage<dim>::stored(const State& state, const double theta_0) const
{
  Energies sum;
  for (unsigned int i = 0; i < state.x.block(block).locally_owned_size(); ++i)
    add_stored(state, theta_0, i, sum);
  return sum;
}

template <int dim>
Energies HeatStorage<dim>::stored_in_walls(const State& state, const double theta_0) const
{
  Energies sum;
  for (const unsigned int i : walls)
    add_stored(state, theta_0, i, sum);
  return sum;
}

template <int dim>
void HeatStorage<dim>::add_stored(const State& state, const double theta_0, const unsigned int i,
                                  Energies& sum) const
{
  const double C = capacities.block(block).local_element(i);
  const double theta = state.x.block(block).local_element(i);
  sum.thermal += C * (theta - theta_0);
  sum.entropy += C * std::log(theta / theta_0);
}

template class HeatStorage<2>;
template class HeatStorage<3>;

} // namespace thelma
