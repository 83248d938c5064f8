#include <thelma/assembly/pressure_blocks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include <utility>

namespace thelma
{

template <int dim>
PressureBlocks<dim>::PressureBlocks(const DofLayout<dim>& layout,
                                    const BoundaryConditions<dim>& conditions,
                                    const Formulation<dim>& formulation,
                                    CellElimination elimination)
    : layout(layout), formulation(formulation), elimination(std::move(elimination)),
      n(formulation.n_kept_pressures()), scratch(layout.new_vector().block(0))
{
  const dealii::types::global_dof_index own = n * layout.cells().size();
  owned = dealii::Utilities::MPI::create_ascending_partitioning(
      layout.communicator(), own)[dealii::Utilities::MPI::this_mpi_process(layout.communicator())];
  for (const auto dof : layout.owned()[0])
    if (conditions.constraints().is_constrained(dof))
      given.push_back(scratch.get_partitioner()->global_to_local(dof));
  compliance.resize(std::size_t(own) * n);
  inverse_schur.resize(std::size_t(own) * n);
}

template <int dim>
void PressureBlocks<dim>::update(const std::function<double(std::size_t)>& shear_modulus)
{
  dealii::FullMatrix<double> C(n, n), schur(n, n);
  for (std::size_t cell = 0; cell < layout.cells().size(); ++cell) {
    const PressureBlock part = block(cell);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j) {
        C(i, j) = part.stiffness[i * n + j];
        schur(i, j) = (*part.mass_inverse)[i][j];
      }
    C.gauss_jordan();
    schur.gauss_jordan();
    schur *= 1. / (2. * shear_modulus(cell));
    schur.add(1., C);
    schur.gauss_jordan();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j) {
        compliance[(cell * n + i) * n + j] = C(i, j);
        inverse_schur[(cell * n + i) * n + j] = schur(i, j);
      }
  }
}

template <int dim>
void PressureBlocks<dim>::add_forces(const Vector& q, Vector& forces) const
{
  scratch = 0.;
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    const PressureBlock part = block(index);
    for (int c = 0; c < dim; ++c)
      for (unsigned int i = 0; i < n; ++i) {
        const double value = q.local_element(index * n + i);
        const double* row = part.gradient + (std::size_t(c) * n + i) * part.stride;
        for (unsigned int a = 0; a < part.n_nodes; ++a)
          scratch.local_element(cell.local[a * cell.n_components + c]) += value * row[a];
      }
  }
  scratch.compress(dealii::VectorOperation::add);
  for (const unsigned int i : given)
    scratch.local_element(i) = 0.;
  for (unsigned int i = 0; i < forces.locally_owned_size(); ++i)
    forces.local_element(i) += scratch.local_element(i);
}

template <int dim>
void PressureBlocks<dim>::apply(const Vector& u, const Vector& q, Vector& residual) const
{
  multiply(compliance, q, residual);
  residual *= -1.;
  scratch.zero_out_ghost_values();
  scratch.copy_locally_owned_data_from(u);
  scratch.update_ghost_values();
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    const PressureBlock part = block(index);
    for (int c = 0; c < dim; ++c) {
      std::array<double, Basis<dim>::max_nodes> values;
      for (unsigned int a = 0; a < part.n_nodes; ++a)
        values[a] = scratch.local_element(cell.local[a * cell.n_components + c]);
      for (unsigned int i = 0; i < n; ++i) {
        const double* row = part.gradient + (std::size_t(c) * n + i) * part.stride;
        double sum = 0.;
        for (unsigned int a = 0; a < part.n_nodes; ++a)
          sum += row[a] * values[a];
        residual.local_element(index * n + i) += sum;
      }
    }
  }
  scratch.zero_out_ghost_values();
}

template <int dim>
void PressureBlocks<dim>::apply_inverse_schur(const Vector& residual, Vector& q) const
{
  multiply(inverse_schur, residual, q);
}

template <int dim>
typename PressureBlocks<dim>::Vector PressureBlocks<dim>::inverse_scales() const
{
  Vector scales = new_vector();
  for (std::size_t i = 0; i < scales.locally_owned_size(); ++i)
    scales.local_element(i) = std::sqrt(inverse_schur[i * n + i % n]);
  return scales;
}

template <int dim>
void PressureBlocks<dim>::multiply(const std::vector<double>& A, const Vector& x, Vector& y) const
{
  for (std::size_t cell = 0; cell < layout.cells().size(); ++cell)
    for (unsigned int i = 0; i < n; ++i) {
      double sum = 0.;
      for (unsigned int j = 0; j < n; ++j)
        sum += A[(cell * n + i) * n + j] * x.local_element(cell * n + j);
      y.local_element(cell * n + i) = sum;
    }
}

template class PressureBlocks<2>;
template class PressureBlocks<3>;

} // namespace thelma
