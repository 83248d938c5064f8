// Factors that do not fit into memory: an error of its own, which no shorter step hides.

#include <thelma/base/error.h>
#include <thelma/solvers/mumps.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace
{

using namespace thelma;

/// The Laplacian of n^3 nodes; its factor has many times as many entries.
void make_laplacian(const unsigned int n, dealii::TrilinosWrappers::SparseMatrix& matrix)
{
  const unsigned int size = n * n * n;
  dealii::DynamicSparsityPattern pattern(size, size);
  const auto for_each = [&](const auto& visit) {
    for (unsigned int i = 0; i < size; ++i) {
      visit(i, i, 6.1);
      const std::array<unsigned int, 3> place{{i % n, i / n % n, i / n / n}}, step{{1, n, n * n}};
      for (unsigned int d = 0; d < 3; ++d)
        if (place[d] + 1 < n) {
          visit(i, i + step[d], -1.);
          visit(i + step[d], i, -1.);
        }
    }
  };
  for_each([&](const unsigned int i, const unsigned int j, double) { pattern.add(i, j); });
  matrix.reinit(pattern);
  for_each(
      [&](const unsigned int i, const unsigned int j, const double v) { matrix.set(i, j, v); });
  matrix.compress(dealii::VectorOperation::insert);
}

/// Of this process, in bytes.
std::size_t address_space()
{
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * sysconf(_SC_PAGESIZE);
}

TEST(Memory, FactorsWithoutRoomAreNoFailedStep)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "its shadow is larger than any limit";
#endif
  constexpr unsigned int n = 36; // 46 656 rows, 150 MB of factors
  dealii::TrilinosWrappers::SparseMatrix matrix;
  make_laplacian(n, matrix);
  Mumps mumps(MPI_COMM_SELF, true);
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  const rlimit tight{address_space() + (80u << 20), limit.rlim_max};
  setrlimit(RLIMIT_AS, &tight);
  EXPECT_THROW(static_cast<void>(mumps.factorise(matrix)), OutOfMemory);
  setrlimit(RLIMIT_AS, &limit);
  EXPECT_TRUE(mumps.factorise(matrix).solved) << "with room";
}

} // namespace
