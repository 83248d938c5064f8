#include <thelma/solvers/eigenpairs.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/parpack_solver.h>
#include <deal.II/lac/read_write_vector.h>

#include <algorithm>

namespace thelma
{
namespace
{

using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

/// ARPACK on one rank.
template <typename Inverse>
std::optional<Eigenpair> smallest_eigenpair_here(const Inverse& inverse, const Vector& start,
                                                 const bool symmetric)
{
  using Arpack = dealii::PArpackSolver<Vector>;
  // A single linear element in the plane has 8 unknowns.
  const auto n_vectors = std::min<dealii::types::global_dof_index>(20, start.size() - 1);
  constexpr int direct = 1; // the eigenvalues of the operator as it is
  dealii::SolverControl control(1000, 1e-10);
  Arpack arpack(
      control, MPI_COMM_SELF,
      {static_cast<unsigned int>(n_vectors), Arpack::largest_magnitude, symmetric, direct});
  arpack.reinit(start.locally_owned_elements());
  arpack.set_initial_vector(start);
  const std::size_t n_parts = symmetric ? 1 : 2; // of a complex vector
  std::vector<std::complex<double>> values(n_parts);
  std::vector<Vector> vectors(n_parts, start);
  try {
    arpack.solve(inverse, inverse, inverse, values, vectors, 1);
  } catch (const dealii::ExceptionBase&) { // how PArpackSolver says so
    return std::nullopt;
  }
  vectors[0] /= vectors[0].l2_norm();
  return Eigenpair{1. / values[0].real(), vectors[0]};
}

/// Vectors as rank 0 has them, whole, and as all ranks share them.
struct Exchange {
  explicit Exchange(const Vector& shared)
      : comm(shared.get_mpi_communicator()),
        leads(dealii::Utilities::MPI::this_mpi_process(comm) == 0), part(shared),
        whole(dealii::complete_index_set(leads ? shared.size() : 0), MPI_COMM_SELF),
        reader(dealii::IndexSet(shared.size()))
  {
    if (leads)
      reader.reinit(dealii::complete_index_set(shared.size()));
  }

  /// The part of each rank of what rank 0 has.
  void deal(const Vector& from)
  {
    std::vector<double> values(part.size());
    if (leads)
      std::copy(from.begin(), from.end(), values.begin());
    values = dealii::Utilities::MPI::broadcast(comm, values, 0);
    for (const auto i : part.locally_owned_elements())
      part(i) = values[i];
  }

  void collect(Vector& to)
  {
#if DEAL_II_VERSION_GTE(9, 5, 0)
    reader.import_elements(part, dealii::VectorOperation::insert);
#else
    reader.import(part, dealii::VectorOperation::insert);
#endif
    if (leads)
      std::copy_n(reader.begin(), to.size(), to.begin());
  }

  const MPI_Comm comm;
  const bool leads;
  Vector part, whole;

private:
  dealii::LinearAlgebra::ReadWriteVector<double> reader;
};

} // namespace

/// Rank 0 leads, the others take part in its solutions: PARPACK refuses ranks without unknowns.
std::optional<Eigenpair> smallest_eigenpair(const std::function<void(Vector&)>& solve,
                                            const Vector& start, const bool symmetric)
{
  Exchange exchange(start);
  struct Inverse {
    Exchange& exchange;
    const std::function<void(Vector&)>& solve;
    bool vmult(Vector& y, const Vector& x) const
    {
      if (!dealii::Utilities::MPI::broadcast(exchange.comm, true, 0))
        return false;
      exchange.deal(x);
      solve(exchange.part);
      exchange.collect(y);
      return true;
    }
  };
  exchange.collect(exchange.whole);
  std::optional<Eigenpair> found;
  if (exchange.leads) {
    found = smallest_eigenpair_here(Inverse{exchange, solve}, exchange.whole, symmetric);
    static_cast<void>(dealii::Utilities::MPI::broadcast(exchange.comm, false, 0));
  } else
    while (Inverse{exchange, solve}.vmult(exchange.whole, exchange.whole)) {
    }
  const bool exists = dealii::Utilities::MPI::broadcast(exchange.comm, found.has_value(), 0);
  if (!exists)
    return std::nullopt;
  exchange.deal(found ? found->vector : exchange.whole);
  const double value = found ? found->value : 0.;
  return Eigenpair{dealii::Utilities::MPI::broadcast(exchange.comm, value, 0), exchange.part};
}

} // namespace thelma
