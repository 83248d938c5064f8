// The eigenpair of smallest size against closed forms.

#include "marks.h"

#include <thelma/solvers/eigenpairs.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

/// Without ghosts; all of a short one is the last rank's.
Vector start_of_length(const unsigned int n)
{
  const unsigned int ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                     rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int share = n < 10 ? 0 : n / ranks;
  dealii::IndexSet own(n);
  own.add_range(rank * share, rank + 1 == ranks ? n : (rank + 1) * share);
  Vector start(own, MPI_COMM_WORLD);
  for (const auto i : own)
    start(i) = std::sin(1. + i);
  return start;
}

ON_TWO_RANKS(Eigenpair);

/// Eigenvalues -0.1 (of entry 3) and 1, 2, 3 ...: far from enough different ones for ARPACK's
/// vectors.
TEST(Eigenpair, OfADiagonalMatrixWithFewUnknowns)
{
  const auto value = [](const unsigned int i) {
    const unsigned int triple = i / 3;
    return i == 3 ? -0.1 : 1. + triple;
  };
  const auto found = thelma::smallest_eigenpair(
      [&](Vector& x) {
        for (const auto i : x.locally_owned_elements())
          x(i) /= value(i);
      },
      start_of_length(8));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->value, -0.1, 1e-14);
  for (const auto i : found->vector.locally_owned_elements())
    EXPECT_NEAR(std::abs(found->vector(i)), i == 3 ? 1. : 0., 1e-12);
}

/// Two eigenvalues of nearly the same size, where inverse iteration would need 1e5 solutions.
TEST(Eigenpair, ToldFromOneOfNearlyTheSameSize)
{
  const auto value = [](const unsigned int i) {
    return i == 50 ? 1e-3 : i == 60 ? -1.0001e-3 : 1. + (i - 50.) * (i - 50.);
  };
  unsigned int n_solutions = 0;
  const auto found = thelma::smallest_eigenpair(
      [&](Vector& x) {
        ++n_solutions;
        for (const auto i : x.locally_owned_elements())
          x(i) /= value(i);
      },
      start_of_length(200));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->value, 1e-3, 1e-15);
  EXPECT_LT(n_solutions, 60);
  for (const auto i : found->vector.locally_owned_elements())
    EXPECT_NEAR(std::abs(found->vector(i)), i == 50 ? 1. : 0., 1e-9);
}

} // namespace
