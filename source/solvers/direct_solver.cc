#include <thelma/solvers/mumps.h>

#include <optional>

namespace thelma
{
namespace
{

/// The condensed tangent, factorised.
class DirectSolver final : public LinearSolver
{
public:
  void setup(const MPI_Comm comm, const LinearProblem& problem, const LinearSettings&) override
  {
    mumps.emplace(comm, problem.is_symmetric);
    counts_pivots = problem.is_symmetric;
  }
  bool has_inertia() const override { return counts_pivots; }
  LinearReport prepare(const Tangent& tangent) override { return mumps->factorise(tangent.matrix); }
  LinearReport solve(dealii::LinearAlgebra::distributed::BlockVector<double>& vector) override
  {
    return mumps->solve(vector);
  }

private:
  std::optional<Mumps> mumps;
  bool counts_pivots = false;
};

} // namespace

std::unique_ptr<LinearSolver> make_direct_solver()
{
  return std::make_unique<DirectSolver>();
}

} // namespace thelma
