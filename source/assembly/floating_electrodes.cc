#include <thelma/assembly/floating_electrodes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <map>

namespace thelma
{

template <int dim>
void FloatingElectrodes<dim>::setup(const bool potential_is_solved)
{
  is_solved = potential_is_solved;
  std::map<dealii::types::global_dof_index, std::size_t> electrode_of;
  for (std::size_t k = 0; k < conditions.electrodes().size(); ++k)
    for (const auto dof : conditions.electrodes()[k].dofs)
      electrode_of[dof] = k;
  touches.assign(layout.cells().size(), {});
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    for (std::size_t i = 0; i < cell.dofs.size(); ++i) {
      const auto found = electrode_of.find(cell.dofs[i]);
      if (found != electrode_of.end())
        touches[index].emplace_back(found->second, i);
    }
  }
}

template <int dim>
std::vector<double> FloatingElectrodes<dim>::charges(const double applied) const
{
  std::vector<double> result;
  for (const Electrode& electrode : conditions.electrodes())
    if (is_solved && electrode.floats)
      result.push_back(electrode.charge_multiple * applied + electrode.kept_charge);
  return result;
}

template <int dim>
std::vector<double> FloatingElectrodes<dim>::sums(const BlockVector& x) const
{
  std::vector<double> own;
  for (const Electrode& electrode : conditions.electrodes())
    if (is_solved && electrode.floats)
      own.push_back(electrode.own_sum(x));
  std::vector<double> all(own.size());
  if (!own.empty())
    dealii::Utilities::MPI::sum(own, layout.communicator(), all);
  return all;
}

template <int dim>
std::vector<std::size_t> FloatingElectrodes<dim>::now_floating() const
{
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < conditions.electrodes().size(); ++k)
    if (is_solved && conditions.electrodes()[k].floats)
      result.push_back(k);
  return result;
}

template <int dim>
void FloatingElectrodes<dim>::clear()
{
  floating = now_floating();
  columns.assign(floating.size(), floating.empty() ? BlockVector() : layout.new_vector());
  rows = columns;
  capacitance.reinit(floating.size(), floating.size());
}

template <int dim>
void FloatingElectrodes<dim>::add(const std::size_t index, const Cell<dim>& cell,
                                  const std::vector<double>& entries)
{
  if (floating.empty())
    return;
  const std::size_t n = cell.dofs.size();
  std::vector<double> column(n), row(n);
  for (std::size_t k = 0; k < floating.size(); ++k) {
    std::fill(column.begin(), column.end(), 0.);
    std::fill(row.begin(), row.end(), 0.);
    bool touched = false;
    for (const auto& [electrode, j] : touches[index])
      if (electrode == floating[k]) {
        touched = true;
        for (std::size_t i = 0; i < n; ++i) {
          column[i] += entries[i * n + j];
          row[i] += entries[j * n + i];
        }
      }
    if (!touched)
      continue;
    layout.scatter(cell, column, columns[k]);
    layout.scatter(cell, row, rows[k]);
    for (const auto& [electrode, i] : touches[index])
      for (std::size_t l = 0; l < floating.size(); ++l)
        if (electrode == floating[l])
          capacitance(l, k) += column[i];
  }
}

template <int dim>
LinearReport FloatingElectrodes<dim>::finish(LinearSolver& solver)
{
  LinearReport report{true, ""};
  if (floating.empty())
    return report;
  const auto owned = layout.dof_handler().locally_owned_dofs();
  dealii::Utilities::MPI::sum(capacitance, layout.communicator(), capacitance);
  for (std::size_t k = 0; k < floating.size(); ++k)
    for (BlockVector* vector : {&columns[k], &rows[k]}) {
      vector->compress(dealii::VectorOperation::add);
      vector->zero_out_ghost_values();
      conditions.constraints().set_zero(*vector);
    }
  responses = columns;
  for (std::size_t k = 0; k < floating.size(); ++k) {
    responses[k] *= -1.;
    LinearReport response = solver.solve(responses[k]);
    if (!response.solved)
      return response;
    report.iterations += response.iterations;
    conditions.constraints().set_zero(responses[k]);
    for (std::size_t l = 0; l < floating.size(); ++l)
      capacitance(l, k) += rows[l] * responses[k];
    for (const auto dof : conditions.electrodes()[floating[k]].dofs)
      if (owned.is_element(dof))
        responses[k](dof) = 1.;
  }
  return report;
}

template <int dim>
void FloatingElectrodes<dim>::correct(const std::vector<double>& right_side, BlockVector& x) const
{
  const std::size_t n = floating.size();
  if (n == 0)
    return;
  dealii::Vector<double> rest(n), potentials(n);
  for (std::size_t k = 0; k < n; ++k)
    rest[k] = right_side[k] - rows[k] * x;
  dealii::FullMatrix<double> inverse(capacitance);
  inverse.gauss_jordan();
  inverse.vmult(potentials, rest);
  for (std::size_t k = 0; k < n; ++k)
    x.add(potentials[k], responses[k]);
}

template <int dim>
long long FloatingElectrodes<dim>::negative_pivots() const
{
  if (floating.empty())
    return 0;
  dealii::LAPACKFullMatrix<double> matrix(floating.size());
  matrix = capacitance;
  matrix.compute_eigenvalues();
  long long count = 0;
  for (std::size_t k = 0; k < floating.size(); ++k)
    count += matrix.eigenvalue(k).real() < 0.;
  return count;
}

template class FloatingElectrodes<2>;
template class FloatingElectrodes<3>;

} // namespace thelma
