#include <thelma/solvers/mixed_operator.h>
#include <thelma/solvers/multigrid.h>
#include <thelma/solvers/mumps.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector_memory.h>

#include <functional>
#include <memory>
#include <optional>

namespace thelma
{
namespace
{

using Vector = MixedOperator::Vector;
using BlockVector = MixedOperator::BlockVector;
using Matrix = CoarseGrid::Matrix;

/// x = approximate inverse times b; empty where a block is the identity.
using Inverse = std::function<void(Vector& x, const Vector& b)>;

/// From the last block to the first: pressures by their Schur complement, temperature, potential
/// and displacements by multigrid or factors, each with what the later ones do to it taken off.
class BlockTriangular
{
public:
  BlockTriangular(const MixedOperator& op, const std::vector<Inverse>& inverses)
      : op(op), inverses(inverses)
  {
  }

  void vmult(BlockVector& z, const BlockVector& scaled) const
  {
    BlockVector r = scaled;
    op.unscale(r);
    const unsigned int n = op.size();
    if (op.pressures()) {
      op.pressures()->apply_inverse_schur(r.block(n), z.block(n));
      op.pressures()->add_forces(z.block(n), r.block(0));
      z.block(n) *= -1.;
    }
    for (unsigned int b = n; b-- > 0;) {
      if (!inverses[b]) {
        z.block(b) = r.block(b);
        continue;
      }
      for (unsigned int c = b + 1; c < n; ++c)
        if (inverses[c])
          op.add(b, c, -1., z.block(c), r.block(b));
      inverses[b](z.block(b), r.block(b));
    }
  }

private:
  const MixedOperator& op;
  const std::vector<Inverse>& inverses;
};

/// positive = -negative, but for rows without equation, whose diagonal is positive in either.
void negate(const Matrix& negative, Matrix& positive)
{
  positive.copy_from(negative);
  positive *= -1.;
  for (const auto row : positive.locally_owned_range_indices())
    if (const double diagonal = positive.diag_element(row); diagonal < 0.)
      positive.set(row, row, -diagonal);
  positive.compress(dealii::VectorOperation::insert);
}

/// FGMRES on the tangent with pressures, preconditioned field by field.
class BlockSolver final : public LinearSolver
{
public:
  void setup(const MPI_Comm comm, const LinearProblem& problem,
             const LinearSettings& chosen) override
  {
    communicator = comm;
    settings = chosen;
    is_flat = problem.flatness > LinearProblem::flat;
    smoothing = problem.flatness > near_cubic ? 2 : 1;
  }

  bool keeps_pressures() const override { return true; }
  bool iterates() const override { return true; }
  bool uses_multigrid() const override { return !is_flat; }

  /// The preconditioner costs a few iterations and saves more when it is the tangent's own.
  LinearReport prepare(const Tangent& tangent) override
  {
    inverses.clear(); // the old ones' memory first
    op.emplace(tangent);
    if (!is_flat)
      tangent.coarse_grids->update();
    inverses.resize(op->size());
    factors.resize(op->size());
    for (unsigned int b = 0; b < op->size(); ++b)
      if (tangent.solved[b]) {
        const Matrix& block = tangent.matrix.block(b, b);
        LinearReport report =
            is_flat ? factorise(b, block) : set_up_cycle(b, block, *tangent.coarse_grids);
        if (!report.solved)
          return report;
      }
    // Assembly against residual and solution: a new tangent hardly costs more than an old one.
    return {true, "", true, 0, 1.5};
  }

  LinearReport solve(BlockVector& vector) override
  {
    BlockVector x = op->new_vector(), b = x;
    for (unsigned int k = 0; k < op->size(); ++k)
      b.block(k).copy_locally_owned_data_from(vector.block(k));
    op->scale(b);
    dealii::SolverControl control(settings.max_iterations, settings.tolerance * b.l2_norm());
    dealii::PrimitiveVectorMemory<BlockVector> memory; // the default keeps the vectors for ever
    dealii::SolverFGMRES<BlockVector> krylov(
        control, memory, dealii::SolverFGMRES<BlockVector>::AdditionalData(most_vectors));
    LinearReport report{true, ""};
    try {
      krylov.solve(*op, x, b, BlockTriangular(*op, inverses));
    } catch (const dealii::SolverControl::NoConvergence&) {
      report.solved = false;
      report.reason = "the block solver did not converge in " +
                      std::to_string(settings.max_iterations) + " iterations";
    }
    report.iterations = control.last_step();
    for (unsigned int k = 0; k < op->size(); ++k)
      vector.block(k).copy_locally_owned_data_from(x.block(k));
    return report;
  }

private:
  static constexpr unsigned int most_vectors = 150; ///< before a restart
  static constexpr double near_cubic = 2.;          ///< flatter cells need more smoothing

  LinearReport set_up_cycle(const unsigned int block, const Matrix& matrix,
                            const CoarseGrids& grids)
  {
    const auto multigrid = std::make_shared<Multigrid>();
    const CoarseGrid coarse = grids.of_block(block);
    inverses[block] = [multigrid, sign = coarse.is_negative ? -1. : 1.](Vector& x,
                                                                        const Vector& b) {
      multigrid->vmult(x, b);
      x *= sign;
    };
    Matrix positive;
    if (coarse.is_negative)
      negate(matrix, positive);
    return multigrid->setup(coarse.is_negative ? positive : matrix, coarse, grids.components(block),
                            block == 0 ? grids.rigid_motions() : std::vector<std::vector<double>>(),
                            smoothing);
  }

  LinearReport factorise(const unsigned int block, const Matrix& matrix)
  {
    if (!factors[block])
      factors[block] = std::make_unique<Mumps>(communicator, true);
    inverses[block] = [this, block](Vector& x, const Vector& b) {
      x = b;
      if (!factors[block]->solve(x).solved)
        x = 0.; // the Krylov method then says that it does not converge
    };
    return factors[block]->factorise(matrix);
  }

  MPI_Comm communicator = MPI_COMM_SELF;
  LinearSettings settings;
  bool is_flat = false;
  unsigned int smoothing = 1;
  std::optional<MixedOperator> op;
  std::vector<Inverse> inverses;
  std::vector<std::unique_ptr<Mumps>> factors; ///< of every block, in a flat body
};

} // namespace

std::unique_ptr<LinearSolver> make_block_solver()
{
  return std::make_unique<BlockSolver>();
}

} // namespace thelma
