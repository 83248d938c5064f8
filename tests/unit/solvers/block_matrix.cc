// Products with blocks are those of Trilinos' matrix they were copied from, on any number of ranks.

#include "marks.h"

#include <thelma/solvers/block_matrix.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace thelma;
using Doubles = BlockMatrix<double>::Vector;
using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;

/// So many groups of @p group, an equal part of them on each rank but the last, which has the rest.
dealii::IndexSet own_part(const unsigned int n_groups, const unsigned int group)
{
  const unsigned int ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD),
                     rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
                     part = n_groups / ranks,
                     end = rank + 1 == ranks ? n_groups : (rank + 1) * part;
  dealii::IndexSet own(n_groups * group);
  own.add_range(rank * part * group, end * group);
  return own;
}

double entry(const unsigned int i, const unsigned int j)
{
  return i == j ? 10. : std::sin(1. + i * 7 + j * 7 + i * j);
}

/// A band with holes: as symmetric as entry() and the holes are.
SparseMatrix matrix(const dealii::IndexSet& rows, const dealii::IndexSet& columns)
{
  const auto for_each = [&](const auto& visit) {
    for (const auto i : rows)
      for (unsigned int j = 0; j < columns.size(); ++j)
        if (i == j || (std::abs(static_cast<double>(i) - j) < 8. && (i * j + i + j) % 5 != 0))
          visit(i, j);
  };
  dealii::DynamicSparsityPattern pattern(rows.size(), columns.size(), rows);
  for_each([&](const auto i, const auto j) { pattern.add(i, j); });
  SparseMatrix result;
  result.reinit(rows, columns, pattern, MPI_COMM_WORLD);
  for_each([&](const auto i, const auto j) { result.set(i, j, entry(i, j)); });
  result.compress(dealii::VectorOperation::insert);
  return result;
}

template <typename Vector>
Vector wavy(Vector x)
{
  for (const auto i : x.locally_owned_elements())
    x(i) = std::cos(3. * i);
  return x;
}

void expect_equal(const Doubles& x, const Doubles& y)
{
  for (const auto i : x.locally_owned_elements())
    EXPECT_NEAR(x(i), y(i), 1e-13 * (1. + std::abs(y(i)))) << i;
}

void expect_products(const unsigned int n_rows, const unsigned int n, const unsigned int n_columns,
                     const unsigned int m)
{
  const SparseMatrix A = matrix(own_part(n_rows, n), own_part(n_columns, m));
  const BlockMatrix<double> blocks(A.trilinos_matrix(), n, m);
  const Doubles x = wavy(blocks.vector_of_columns()), f = wavy(blocks.vector_of_rows());
  Doubles y = f, expected = f, product = f;
  A.vmult(product, x);
  expected.add(-2., product);
  blocks.add(-2., x, y);
  expect_equal(y, expected);

  Doubles z = x, transposed = x;
  A.Tvmult(transposed, f);
  transposed *= 3.;
  transposed += x;
  blocks.add_transposed(3., f, z);
  expect_equal(z, transposed);
}

ON_TWO_RANKS(BlockMatrix);

TEST(BlockMatrix, MultipliesLikeTheMatrix)
{
  expect_products(12, 1, 12, 1);
  expect_products(12, 3, 12, 3);
  expect_products(9, 2, 14, 3);
  expect_products(9, 3, 27, 1);
  expect_products(40, 3, 4, 3); // many more rows than columns
  expect_products(40, 1, 1, 1); // some ranks have no column
}

TEST(BlockMatrix, KeepsHalfOfASymmetricMatrix)
{
  for (const unsigned int group : {1, 2, 3}) {
    const dealii::IndexSet own = own_part(13, group);
    const SparseMatrix A = matrix(own, own);
    const BlockMatrix<double> blocks(A.trilinos_matrix(), group);
    const Doubles x = wavy(blocks.vector_of_columns());
    Doubles y = x, expected = x;
    A.vmult(expected, x);
    blocks.vmult(y, x);
    expect_equal(y, expected);
  }
}

TEST(BlockMatrix, InvertsItsDiagonal)
{
  const dealii::IndexSet own = own_part(7, 3);
  const SparseMatrix A = matrix(own, own);
  const BlockMatrix<float> inverse =
      BlockMatrix<float>(A.trilinos_matrix(), 3).inverse_of_diagonal();
  auto x = wavy(inverse.vector_of_columns()), y = x;
  inverse.vmult(y, x);
  for (const auto i : own) {
    double sum = 0.;
    for (unsigned int j = i - i % 3; j < i - i % 3 + 3; ++j)
      sum += A.el(i, j) * y(j);
    EXPECT_NEAR(sum, x(i), 1e-6);
  }
}

} // namespace
