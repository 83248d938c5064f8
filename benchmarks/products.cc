// Nanoseconds per entry of products with the blocks of a tangent: Trilinos' and those of
// BlockMatrix. Run alone on the machine: build/bin/benchmark_products

#include "scene.h"
#include "timing.h"

#include <thelma/solvers/block_matrix.h>

#include <cstdio>
#include <type_traits>

namespace
{

using namespace thelma_test;
using thelma::BlockMatrix;

template <typename Number>
double product(const BlockMatrix<Number>& matrix)
{
  auto x = matrix.vector_of_columns(), y = matrix.vector_of_rows();
  x = Number(1.);
  return 1e9 * shortest_seconds([&]() { matrix.vmult(y, x); });
}

void print(const char* name, const dealii::TrilinosWrappers::SparseMatrix& block,
           const double doubles, const double singles)
{
  dealii::LinearAlgebra::distributed::Vector<double> x(block.locally_owned_domain_indices(),
                                                       MPI_COMM_WORLD),
      y(block.locally_owned_range_indices(), MPI_COMM_WORLD);
  x = 1.;
  const auto entries = static_cast<double>(block.n_nonzero_elements());
  std::printf("%-28s %9.0f entries  Trilinos %5.2f  double %5.2f  single %5.2f\n", name, entries,
              1e9 * shortest_seconds([&]() { block.vmult(y, x); }) / entries, doubles / entries,
              singles / entries);
}

void measure()
{
  TestScene<3> scene("subsection Mesh\n set File = meshes/bilayer.geo\n"
                     " set Parameters = L: 20, W: 4, H: 1, n1: 4, n2: 12, n3: 60\nend\n"
                     "subsection Regions\n set Materials = active: elastomer, passive: elastomer\n"
                     " set Passive = passive\nend\nsubsection Discretisation\n set Degree = 2\n"
                     " set Formulation = mean dilatation\nend\nsubsection Supports\n"
                     " set Fixed = x3_min: u3, x2_min: u2, x2_max: u2, pin: u1\nend\n"
                     "subsection Electrodes\n set Potential = interface: 0, outer: 1\nend\n");
  scene.system.linear.assemble();
  const auto& tangent = scene.system.linear.matrix();
  const auto &uu = tangent.block(0, 0), &u_phi = tangent.block(0, 1),
             &phi_phi = tangent.block(1, 1);
  const auto rectangular = [](const auto number, const auto& block) {
    return product(BlockMatrix<std::decay_t<decltype(number)>>(block.trilinos_matrix(), 3, 1));
  };
  const auto symmetric = [](const auto number, const auto& block, const unsigned int group) {
    return product(BlockMatrix<std::decay_t<decltype(number)>>(block.trilinos_matrix(), group));
  };
  std::printf("nanoseconds per entry, of a symmetric matrix of all its entries\n");
  print("u, u: symmetric, 3 x 3", uu, symmetric(0., uu, 3), symmetric(0.F, uu, 3));
  print("phi, phi: symmetric, 1 x 1", phi_phi, symmetric(0., phi_phi, 1),
        symmetric(0.F, phi_phi, 1));
  print("u, phi: 3 x 1", u_phi, rectangular(0., u_phi), rectangular(0.F, u_phi));
}

} // namespace

int main(int argc, char** argv) // NOLINT: what is thrown may end it
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  measure();
}
