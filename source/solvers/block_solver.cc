#include <thelma/solvers/multigrid.h>
#include <thelma/solvers/mumps.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector_memory.h>

#include <cmath>
#include <functional>
#include <memory>
#include <optional>

namespace thelma
{
namespace
{

using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;
using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;

/// x = approximate inverse times b; empty where a block is the identity.
using Inverse = std::function<void(Vector& x, const Vector& b)>;

/// The tangent with its pressures as last block. Rows are scaled so that the norm of a residual
/// makes sense in whatever units its fields have.
class MixedOperator
{
public:
  explicit MixedOperator(const Tangent& tangent)
      : tangent(tangent), n(tangent.matrix.n_block_rows())
  {
    std::vector<double> sizes;
    for (unsigned int b = 0; b < n; ++b) {
      const auto& block = tangent.matrix.block(b, b);
      sizes.push_back(block.frobenius_norm() / std::sqrt(static_cast<double>(block.m())));
      row_scales.push_back(std::sqrt(sizes[0] / sizes[b]));
    }
    if (tangent.pressures) {
      pressure_scales = tangent.pressures->inverse_scales();
      pressure_scales *= std::sqrt(sizes[0]);
    }
  }

  /// A zero vector of the unknowns, without ghosts.
  BlockVector new_vector() const
  {
    BlockVector vector(n + (tangent.pressures ? 1 : 0));
    for (unsigned int b = 0; b < n; ++b)
      vector.block(b).reinit(tangent.matrix.block(b, b).locally_owned_range_indices(),
                             tangent.matrix.get_mpi_communicator());
    if (tangent.pressures)
      vector.block(n) = tangent.pressures->new_vector();
    vector.collect_sizes();
    return vector;
  }

  void vmult(BlockVector& y, const BlockVector& x) const
  {
    for (unsigned int b = 0; b < n; ++b) {
      tangent.matrix.block(b, b).vmult(y.block(b), x.block(b));
      for (unsigned int c = 0; c < n; ++c)
        if (c != b)
          add(b, c, 1., x.block(c), y.block(b));
    }
    if (tangent.pressures) {
      tangent.pressures->add_forces(x.block(n), y.block(0));
      tangent.pressures->apply(x.block(0), x.block(n), y.block(n));
    }
    scale(y);
  }

  /// y += factor K_bc x.
  void add(const unsigned int b, const unsigned int c, const double factor, const Vector& x,
           Vector& y) const
  {
    const SparseMatrix& block = tangent.matrix.block(b, c);
    if (block.n_nonzero_elements() == 0)
      return;
    Vector product(y);
    block.vmult(product, x);
    y.add(factor, product);
  }

  void scale(BlockVector& y) const
  {
    for (unsigned int b = 0; b < n; ++b)
      y.block(b) *= row_scales[b];
    if (tangent.pressures)
      y.block(n).scale(pressure_scales);
  }

  void unscale(BlockVector& y) const
  {
    for (unsigned int b = 0; b < n; ++b)
      y.block(b) /= row_scales[b];
    if (tangent.pressures)
      for (std::size_t i = 0; i < pressure_scales.locally_owned_size(); ++i)
        y.block(n).local_element(i) /= pressure_scales.local_element(i);
  }

  Tangent tangent;
  unsigned int n; ///< blocks without the pressures

private:
  std::vector<double> row_scales;
  Vector pressure_scales;
};

/// From the last block to the first: pressures by their Schur complement, temperature, potential
/// and displacements by multigrid, each with what the later ones do to it taken off.
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
    const unsigned int n = op.n;
    if (op.tangent.pressures) {
      op.tangent.pressures->apply_inverse_schur(r.block(n), z.block(n));
      op.tangent.pressures->add_forces(z.block(n), r.block(0));
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
      if (op.tangent.surrogates->matrix(b) && b > 0)
        z.block(b) *= -1.; // the potential's block is negative
    }
  }

private:
  const MixedOperator& op;
  const std::vector<Inverse>& inverses;
};

/// FGMRES on the tangent with pressures, preconditioned field by field.
class BlockSolver final : public LinearSolver
{
public:
  void setup(const MPI_Comm comm, const LinearProblem& problem,
             const LinearSettings& chosen) override
  {
    settings = chosen;
    if (problem.flatness > LinearProblem::flat)
      factors = std::make_unique<Mumps>(comm, true);
  }

  bool keeps_pressures() const override { return true; }
  bool iterates() const override { return true; }
  bool uses_multigrid() const override { return !factors; }

  /// The preconditioner costs a few iterations and saves more when it is the tangent's own.
  LinearReport prepare(const Tangent& tangent) override
  {
    op.emplace(tangent);
    tangent.surrogates->update();
    inverses.assign(op->n, {});
    for (unsigned int b = 0; b < op->n; ++b)
      if (tangent.solved[b]) {
        const SparseMatrix* stand_in = tangent.surrogates->matrix(b);
        const SparseMatrix& matrix = stand_in ? *stand_in : tangent.matrix.block(b, b);
        if (b == 0 && factors) {
          if (const LinearReport report = factors->factorise(matrix); !report.solved)
            return report;
          inverses[b] = [this](Vector& x, const Vector& r) {
            x = r;
            factors->solve(x);
          };
        } else
          inverses[b] = cycle(b, matrix, *tangent.surrogates);
      }
    // Assembly against residual and solution: a new tangent hardly costs more than an old one.
    return {true, "", true, 0, 1.5};
  }

  LinearReport solve(BlockVector& vector) override
  {
    BlockVector x = op->new_vector(), b = x;
    for (unsigned int k = 0; k < op->n; ++k)
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
    for (unsigned int k = 0; k < op->n; ++k)
      vector.block(k).copy_locally_owned_data_from(x.block(k));
    return report;
  }

private:
  static constexpr unsigned int most_vectors = 80; ///< before a restart

  static Inverse cycle(const unsigned int block, const SparseMatrix& matrix,
                       const Surrogates& surrogates)
  {
    const auto multigrid = std::make_shared<Multigrid>();
    multigrid->setup(matrix, block == 0 ? surrogates.components(block) : 1,
                     block == 0 ? surrogates.rigid_motions() : std::vector<std::vector<double>>());
    return [multigrid](Vector& x, const Vector& b) { multigrid->vmult(x, b); };
  }

  LinearSettings settings;
  std::optional<MixedOperator> op;
  std::vector<Inverse> inverses;
  std::unique_ptr<Mumps> factors; ///< of the displacements' stand-in, in a flat body
};

} // namespace

std::unique_ptr<LinearSolver> make_block_solver()
{
  return std::make_unique<BlockSolver>();
}

} // namespace thelma
