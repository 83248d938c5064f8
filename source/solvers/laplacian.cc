#include <thelma/solvers/laplacian.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

namespace thelma
{

Laplacian::Laplacian(const Matrix& laplacian, const unsigned int n_components, const bool iterates)
{
  if (iterates) {
    matrix = &laplacian;
    multigrid.setup(matrix->block(0, 0), n_components, {});
    return;
  }
  factors = std::make_unique<Mumps>(laplacian.get_mpi_communicator(), true, Mumps::Ordering::quick);
  factors->factorise(laplacian);
}

void Laplacian::solve(BlockVector& vector)
{
  if (factors)
    return factors->solve(vector);
  const auto& block = matrix->block(0, 0);
  Multigrid::Vector b(block.locally_owned_range_indices(), block.get_mpi_communicator());
  b.copy_locally_owned_data_from(vector.block(0));
  Multigrid::Vector x(b);
  x = 0.;
  dealii::SolverControl control(100, 1e-6 * b.l2_norm());
  try {
    dealii::SolverCG<Multigrid::Vector>(control).solve(block, x, b, multigrid);
  } catch (const dealii::SolverControl::NoConvergence&) { // what there is does for a guess
  }
  vector.block(0).copy_locally_owned_data_from(x);
}

} // namespace thelma
