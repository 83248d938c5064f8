#pragma once

#include <thelma/base/named_list.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/trilinos_block_sparse_matrix.h>

#include <string>
#include <vector>

namespace thelma
{

/// Outcome of one linear solve.
struct [[nodiscard]] LinearReport {
  bool solved;
  std::string reason;            ///< why not
  bool factorised = false;       ///< a new tangent
  long long negative_pivots = 0; ///< of a factorisation; if unsymmetric, 1 where det < 0
  double cost = 1.; ///< of a new tangent, in iterations that reuse one; a count, not a time
  unsigned int iterations = 0; ///< of a Krylov method
};

/// Pressures q of single cells that a tangent keeps as unknowns (theory.md, eq. 80):
///   [ A  B^T ] [x]   [r]
///   [ B  -C  ] [q] = [0].
class CellPressures
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;
  virtual ~CellPressures() = default;

  /// A zero vector of all pressures.
  virtual Vector new_vector() const = 0;

  /// forces += B^T q, but nothing where the displacement is given.
  virtual void add_forces(const Vector& q, Vector& forces) const = 0;

  /// residual = B u - C q.
  virtual void apply(const Vector& u, const Vector& q, Vector& residual) const = 0;

  /// q = (C + M / (2 mu))^-1 residual, with the mass matrix M: what B A^-1 B^T comes down to.
  virtual void apply_inverse_schur(const Vector& residual, Vector& q) const = 0;

  /// Inverse square roots of the diagonal of C + M / (2 mu).
  virtual Vector inverse_scales() const = 0;
};

/// Where multigrid goes on from a diagonal block of a tangent.
struct CoarseGrid {
  using Matrix = dealii::TrilinosWrappers::SparseMatrix;
  const Matrix* matrix = nullptr;       ///< positive; null where there is none
  const Matrix* prolongation = nullptr; ///< to the block's own unknowns
  bool is_negative = false;             ///< the block itself, but for rows without equation
};

/// Those of all blocks.
class CoarseGrids
{
public:
  virtual ~CoarseGrids() = default;

  /// Build those of the present state.
  virtual void update() = 0;

  virtual CoarseGrid of_block(unsigned int block) const = 0;

  /// What displaces no cell relative to itself on the coarse grid, one vector of this rank's
  /// entries each.
  virtual const std::vector<std::vector<double>>& rigid_motions() const = 0;

  /// Components of a node, which follow one another.
  virtual unsigned int components(unsigned int block) const = 0;
};

/// A linearised balance as solvers see it.
struct Tangent {
  const dealii::TrilinosWrappers::BlockSparseMatrix& matrix;
  const CellPressures* pressures = nullptr; ///< null: condensed
  CoarseGrids* coarse_grids = nullptr;      ///< for solvers that keep pressures
  std::vector<bool> solved = {};            ///< blocks that are no identity
  unsigned int n_symmetric = 0; ///< the first so many blocks, and those between them, are symmetric
};

/// What a .prm says of all linear solvers.
struct LinearSettings {
  std::string solver = "automatic";
  double tolerance = 1e-8;
  unsigned int max_iterations = 300;

  void declare(dealii::ParameterHandler& prm);
};

/// What decides between the solvers and what they make ready for.
struct LinearProblem {
  /// Cells of this flatness are too flat for multigrid, and a body of them has small factors
  /// (doc/scaling.md).
  static constexpr double flat = 5.;

  unsigned int dimension = 3;
  unsigned long long unknowns = 0;
  double flatness = 1.; ///< longest over shortest edge of a cell, on average
  bool is_symmetric = true, pressures_can_be_kept = false;
  std::string counts_for; ///< entry of the scene that needs unstable directions; empty: none
};

/// Solves with one tangent after the other. A new solver is one file and one line in
/// solver_list.cc.
class LinearSolver
{
public:
  virtual ~LinearSolver() = default;

  virtual void setup(MPI_Comm comm, const LinearProblem& problem,
                     const LinearSettings& settings) = 0;

  /// Whether it wants the pressures of the cells as unknowns, not condensed.
  virtual bool keeps_pressures() const { return false; }

  /// Whether LinearReport::iterations is.
  virtual bool iterates() const { return false; }

  /// Whether it works by multigrid, in a body whose factors are too large.
  virtual bool uses_multigrid() const { return false; }

  /// Whether LinearReport::negative_pivots is known.
  virtual bool has_inertia() const { return false; }

  /// Make ready to solve with @p tangent, which stays as it is until the next.
  virtual LinearReport prepare(const Tangent& tangent) = 0;

  /// Replace the owned entries of @p vector by the solution with them as right-hand side.
  virtual LinearReport solve(dealii::LinearAlgebra::distributed::BlockVector<double>& vector) = 0;
};

const NamedList<LinearSolver>& linear_solvers();

std::unique_ptr<LinearSolver> make_direct_solver();
std::unique_ptr<LinearSolver> make_block_solver();

/// A solver by name, and why that one.
struct LinearChoice {
  std::string solver, reason;
};

LinearChoice choose_linear_solver(const LinearSettings& settings, const LinearProblem& problem);

} // namespace thelma
