#include <thelma/assembly/rank_shares.h>

#include <deal.II/base/mpi.h>

#include <Epetra_CrsMatrix.h>

namespace thelma
{

template <int dim>
std::map<std::string, double> imbalance(const DofLayout<dim>& layout,
                                        const dealii::TrilinosWrappers::BlockSparseMatrix& tangent)
{
  double nonzeros = 0.;
  for (unsigned int i = 0; i < tangent.n_block_rows(); ++i)
    for (unsigned int j = 0; j < tangent.n_block_cols(); ++j)
      nonzeros += tangent.block(i, j).trilinos_matrix().NumMyNonzeros();
  const auto ratio = [&](const double own) {
    const auto share = dealii::Utilities::MPI::min_max_avg(own, layout.communicator());
    return share.max / share.avg;
  };
  return {{"cells", ratio(layout.cells().size())}, {"nonzeros", ratio(nonzeros)}};
}

template <int dim>
double ghost_share(const DofLayout<dim>& layout)
{
  double own = 0., needed = 0.;
  for (unsigned int b = 0; b < layout.owned().size(); ++b) {
    dealii::IndexSet others = layout.relevant()[b];
    others.subtract_set(layout.owned()[b]);
    own += layout.owned()[b].n_elements();
    needed += others.n_elements();
  }
  const MPI_Comm comm = layout.communicator();
  return dealii::Utilities::MPI::max(needed, comm) /
         dealii::Utilities::MPI::min_max_avg(own, comm).avg;
}

template std::map<std::string, double>
imbalance(const DofLayout<2>&, const dealii::TrilinosWrappers::BlockSparseMatrix&);
template std::map<std::string, double>
imbalance(const DofLayout<3>&, const dealii::TrilinosWrappers::BlockSparseMatrix&);
template double ghost_share(const DofLayout<2>&);
template double ghost_share(const DofLayout<3>&);

} // namespace thelma
