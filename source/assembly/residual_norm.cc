#include <thelma/assembly/residual_norm.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace thelma
{
namespace
{

/// Also of what is no number, at which l2_norm() ends a Debug build.
double norm(const BlockVector::BlockType& x)
{
  double sum = 0.;
  for (const double value : x)
    sum += value * value;
  return std::sqrt(dealii::Utilities::MPI::sum(sum, x.get_mpi_communicator()));
}

} // namespace

template <int dim>
void ResidualNorm<dim>::setup(const CellLoop<dim>& cells, const State& state)
{
  const Integration<dim> rule(layout, layout.degree() + 1);
  BlockVector forces = layout.new_vector();
  volume = 0.;
  cells.for_each([&](const CellView<dim>& view) {
    const auto units_of = flux_units(*view.cell.material, state.theta);
    const int n_c = view.cell.n_components;
    for (unsigned int q = 0; q < rule.basis().n_points; ++q) {
      const auto& point = rule.of_cell(view.index)[q];
      volume += point.JxW;
      for (unsigned int a = 0; a < rule.basis().n_nodes; ++a) {
        dealii::Tensor<1, dim> reference;
        for (int K = 0; K < dim; ++K)
          reference[K] = rule.basis().dN[(q * dim + K) * rule.basis().stride + a];
        const double size =
            point.JxW * (dealii::transpose(point.inverse_jacobian) * reference).norm();
        for (int c = 0; c < n_c; ++c)
          forces(view.cell.dofs[a * n_c + c]) +=
              size * units_of[static_cast<std::size_t>(view.cell.field_of(c))];
      }
    }
  });
  volume = dealii::Utilities::MPI::sum(volume, layout.communicator());
  forces.compress(dealii::VectorOperation::add);
  charge_units.clear();
  for (const Electrode& electrode : conditions.electrodes())
    charge_units.push_back(
        dealii::Utilities::MPI::sum(electrode.own_sum(forces), layout.communicator()));
  conditions.constraints().set_zero(forces);
  units.clear();
  for (unsigned int b = 0; b < forces.n_blocks(); ++b)
    units.push_back(forces.block(b).l2_norm());
}

/// A wrong temperature is as bad where it is stored as where it is conducted.
template <int dim>
double ResidualNorm<dim>::unit(const unsigned int block, const State& state) const
{
  const bool is_temperature =
      layout.has(Field::temperature) && block == layout.block(Field::temperature);
  const double size = units[block] + (is_temperature ? storage.storage_scale(state) : 0.);
  return size > 0. ? size : 1.; // where all is given
}

template <int dim>
void ResidualNorm<dim>::include_internal(const double squares, ResidualReport& report) const
{
  report.include(std::sqrt(dealii::Utilities::MPI::sum(squares, layout.communicator()) / volume));
}

template <int dim>
void ResidualNorm<dim>::include_nodal(const BlockVector& residual, const State& state,
                                      ResidualReport& report) const
{
  for (unsigned int b = 0; b < residual.n_blocks(); ++b)
    report.include(norm(residual.block(b)) / unit(b, state));
}

template <int dim>
void ResidualNorm<dim>::include_charges(const FloatingElectrodes<dim>& floating,
                                        const BlockVector& reactions, const State& state,
                                        ResidualReport& report) const
{
  const std::vector<double> charges = floating.charges(state.charge),
                            sums = floating.sums(reactions);
  std::size_t e = 0;
  for (std::size_t k = 0; k < charges.size(); ++k, ++e) {
    while (!conditions.electrodes()[e].floats)
      ++e;
    report.include(std::abs(sums[k] + charges[k]) / charge_units[e]);
  }
}

template class ResidualNorm<2>;
template class ResidualNorm<3>;

} // namespace thelma
