#pragma once

#include <thelma/fields/dof_layout.h>

#include <deal.II/lac/trilinos_block_sparse_matrix.h>

#include <map>
#include <string>

namespace thelma
{

/// Of cells and of the entries of a tangent: the largest share of a rank over the mean.
template <int dim>
std::map<std::string, double> imbalance(const DofLayout<dim>& layout,
                                        const dealii::TrilinosWrappers::BlockSparseMatrix& tangent);

/// The most unknowns that a rank needs of others, over the mean of its own.
template <int dim>
double ghost_share(const DofLayout<dim>& layout);

} // namespace thelma
