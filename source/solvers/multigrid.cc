#include <thelma/solvers/multigrid.h>

#include <deal.II/base/mpi.h>

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

namespace thelma
{

void Multigrid::setup(const Matrix& matrix, const unsigned int n_components,
                      const std::vector<std::vector<double>>& null_space)
{
  modes.clear();
  for (const std::vector<double>& mode : null_space)
    modes.insert(modes.end(), mode.begin(), mode.end());

  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("ML output", 0);
  list.set("PDE equations", static_cast<int>(n_components));
  // A maximal independent set saves a sixth of the iterations, but wants all unknowns of a ghost
  // aggregate as columns, and small aggregates lack some; there better smoothing makes up for half.
  const bool alone = dealii::Utilities::MPI::n_mpi_processes(matrix.get_mpi_communicator()) == 1;
  list.set("aggregation: type", alone ? "MIS" : "Uncoupled");
  list.set("aggregation: threshold", 0.);
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: sweeps", alone ? 2 : 3); // the degree
  // What coarser levels leave over lies in the upper part of the spectrum.
  list.set("smoother: Chebyshev alpha", alone ? 7. : 10.);
  list.set("coarse: type", "Amesos-KLU");
  list.set("coarse: max size", 2000);
  if (!null_space.empty()) {
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension", static_cast<int>(null_space.size()));
    list.set("null space: vectors", modes.data());
    list.set("null space: add default vectors", false);
  }
  cycle = std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>();
  cycle->initialize(matrix, list);
}

} // namespace thelma
