#pragma once

#include <deal.II/lac/la_parallel_vector.h>

#include <functional>
#include <optional>

namespace thelma
{

/// An eigenvalue and its eigenvector of length 1.
struct Eigenpair {
  double value;
  dealii::LinearAlgebra::distributed::Vector<double> vector;
};

/// The eigenpair of smallest size of a matrix, by ARPACK on its inverse: @p solve replaces a vector
/// by the inverse times it. @p start is without ghosts and should lack no eigenvector. Of a matrix
/// that is not @p symmetric it is taken for real, as it is where it passes zero. Nothing where
/// ARPACK does not converge.
std::optional<Eigenpair> smallest_eigenpair(
    const std::function<void(dealii::LinearAlgebra::distributed::Vector<double>&)>& solve,
    const dealii::LinearAlgebra::distributed::Vector<double>& start, bool symmetric = true);

} // namespace thelma
