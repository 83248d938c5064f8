#include <thelma/solvers/laplacian.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

namespace thelma
{

Laplacian::Laplacian(const Matrix& matrix, const bool iterates)
{
  if (iterates) {
    block = BlockMatrix<double>(matrix.block(0, 0).trilinos_matrix(), 1);
    works = multigrid.setup(matrix.block(0, 0), {}, 1, {}).solved;
    return;
  }
  factors = std::make_unique<Mumps>(matrix.get_mpi_communicator(), true, Mumps::Ordering::quick);
  works = factors->factorise(matrix).solved;
}

void Laplacian::solve(BlockVector& vector)
{
  if (!works) {
    vector.block(0) = 0.;
    return;
  }
  if (factors) {
    works = factors->solve(vector).solved;
    return;
  }
  BlockMatrix<double>::Vector b = block.vector_of_rows(), x = b;
  b.copy_locally_owned_data_from(vector.block(0));
  dealii::SolverControl control(100, 1e-6 * b.l2_norm());
  try {
    dealii::SolverCG<BlockMatrix<double>::Vector>(control).solve(block, x, b, multigrid);
  } catch (const dealii::SolverControl::NoConvergence&) { // what there is does for a guess
  }
  vector.block(0).copy_locally_owned_data_from(x);
}

} // namespace thelma
