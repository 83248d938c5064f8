#include <thelma/solvers/multigrid.h>

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>
#include <ml_epetra_utils.h>

namespace thelma
{
namespace
{

using Doubles = dealii::LinearAlgebra::distributed::Vector<double>;

std::unique_ptr<Epetra_CrsMatrix> convert(ML_Operator& from)
{
  Epetra_CrsMatrix* matrix = nullptr;
  ML_Operator2EpetraCrsMatrix(&from, matrix);
  return std::unique_ptr<Epetra_CrsMatrix>(matrix);
}

} // namespace

LinearReport Multigrid::setup(const Matrix& matrix, const CoarseGrid& coarse,
                              const unsigned int n_components,
                              const std::vector<std::vector<double>>& null_space,
                              const unsigned int degree)
{
  levels.clear();
  if (coarse.matrix)
    add_level(matrix.trilinos_matrix(), n_components,
              BlockMatrix<float>(coarse.prolongation->trilinos_matrix(), 1, 1), degree);
  return add_aggregates(coarse.matrix ? *coarse.matrix : matrix, n_components, null_space);
}

/// Further levels by aggregation, down to one that is factorised.
LinearReport Multigrid::add_aggregates(const Matrix& matrix, const unsigned int n_components,
                                       const std::vector<std::vector<double>>& null_space)
{
  std::vector<double> modes;
  for (const std::vector<double>& mode : null_space)
    modes.insert(modes.end(), mode.begin(), mode.end());
  modes.push_back(0.); // ML wants an address also of a rank that has no unknowns

  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("ML output", 0);
  list.set("PDE equations", static_cast<int>(n_components));
  list.set("aggregation: type", "Uncoupled");
  list.set("aggregation: threshold", 0.);
  list.set("increasing or decreasing", "increasing");
  list.set("smoother: type", "do-nothing");
  list.set("coarse: type", "do-nothing");
  list.set("coarse: max size", 2000);
  if (!null_space.empty()) {
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension", static_cast<int>(null_space.size()));
    list.set("null space: vectors", modes.data());
    list.set("null space: add default vectors", false);
  }
  const ML_Epetra::MultiLevelPreconditioner preconditioner(matrix.trilinos_matrix(), list, true);
  const ML& ml = *preconditioner.GetML();

  const unsigned int group_of_coarser = null_space.empty() ? 1 : 3; // 3 or 6 motions
  std::unique_ptr<Epetra_CrsMatrix> coarser;
  for (int level = 0; level < ml.ML_coarsest_level; ++level) {
    const unsigned int group = level == 0 ? n_components : group_of_coarser;
    add_level(level == 0 ? matrix.trilinos_matrix() : *coarser, group,
              BlockMatrix<float>(*convert(ml.Pmat[level + 1]), group, group_of_coarser), 3);
    coarser = convert(ml.Amat[level + 1]);
  }
  coarsest = std::make_unique<Mumps>(matrix.get_mpi_communicator(), true, Mumps::Ordering::quick);
  if (!coarser)
    return coarsest->factorise(matrix);
  Matrix small;
  small.reinit(*coarser);
  return coarsest->factorise(small);
}

void Multigrid::add_level(const Epetra_CrsMatrix& matrix, const unsigned int group,
                          BlockMatrix<float>&& prolongation, const unsigned int degree)
{
  auto level = std::make_unique<Level>();
  level->matrix = BlockMatrix<float>(matrix, group);
  level->prolongation = std::move(prolongation);
  level->residual = level->matrix.vector_of_rows();
  level->coarse_residual = level->coarse_correction = level->prolongation.vector_of_columns();
  Smoother::AdditionalData data;
  data.degree = degree;
  // What coarser levels leave over lies in the upper part of the spectrum.
  data.smoothing_range = 5.;
  data.preconditioner = std::make_shared<BlockMatrix<float>>(level->matrix.inverse_of_diagonal());
  level->smoother.initialize(level->matrix, data);
  level->smoother.estimate_eigenvalues(level->residual);
  levels.push_back(std::move(level));
}

void Multigrid::cycle(const std::size_t index, Vector& x, const Vector& b) const
{
  if (index == levels.size()) {
    Doubles solution(b.get_partitioner());
    solution.copy_locally_owned_data_from(b);
    if (!coarsest->solve(solution).solved)
      solution = 0.; // the Krylov method then says that it does not converge
    x.copy_locally_owned_data_from(solution);
    return;
  }
  const Level& level = *levels[index];
  level.smoother.vmult(x, b);
  level.residual.copy_locally_owned_data_from(b); // assignment would ask all ranks
  level.matrix.add(-1.F, x, level.residual);
  level.coarse_residual = 0.F;
  level.prolongation.add_transposed(1.F, level.residual, level.coarse_residual);
  cycle(index + 1, level.coarse_correction, level.coarse_residual);
  level.prolongation.add(1.F, level.coarse_correction, x);
  level.smoother.step(x, b);
}

void Multigrid::vmult(Doubles& x, const Doubles& b) const
{
  Vector single_x(b.get_partitioner()), single_b(b.get_partitioner());
  single_b.copy_locally_owned_data_from(b);
  vmult(single_x, single_b);
  x.copy_locally_owned_data_from(single_x);
}

} // namespace thelma
