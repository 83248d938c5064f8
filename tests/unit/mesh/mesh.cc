// A mesh dealt out to the ranks: each has only its part, all of them together have all of it.

#include "marks.h"

#include <thelma/mesh/mesh.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

namespace
{

using namespace thelma;

/// A strip of 2 x 2 x 64 cells.
class DealtOut : public testing::Test
{
protected:
  DealtOut() : mesh(MPI_COMM_WORLD)
  {
    dealii::ParameterHandler prm;
    mesh.declare(prm);
    prm.parse_input_from_string("subsection Mesh\n set File = meshes/bilayer.geo\n"
                                " set Parameters = L: 64, W: 2, H: 2, n1: 2, n2: 2, n3: 64\nend\n");
    mesh.read(THELMA_SOURCE_DIR);
  }

  template <typename Number>
  static Number sum(const Number own)
  {
    return dealii::Utilities::MPI::sum(own, MPI_COMM_WORLD);
  }

  Mesh<3> mesh;
};
ON_TWO_RANKS(DealtOut);

TEST_F(DealtOut, MeshGivesEveryCellToOneRank)
{
  const auto& tria = mesh.triangulation();
  std::vector<unsigned int> owners(mesh.n_cells(), 0);
  for (const auto& cell : tria.active_cell_iterators())
    if (cell->is_locally_owned())
      ++owners.at(Mesh<3>::number_of(cell));
  dealii::Utilities::MPI::sum(owners, MPI_COMM_WORLD, owners);
  EXPECT_EQ(owners, std::vector<unsigned int>(mesh.n_cells(), 1));
}

TEST_F(DealtOut, MeshIsWholeOnNoRankOfSeveral)
{
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const unsigned int n = mesh.n_cells(), layer = n / 64;
  const unsigned int share = n / n_ranks;
  // METIS cuts the strip across: some layers more or less, and one of ghosts at either end.
  EXPECT_LE(mesh.triangulation().n_active_cells(), n_ranks == 1 ? n : share + 4 * layer);
}

TEST_F(DealtOut, MeshHasEveryFaceOfASurfaceOnce)
{
  double area = 0.;
  for (const auto& [cell, vertices] : mesh.surface("outer", ""))
    for (unsigned int f = 0; f < 6; ++f)
      if (face_vertices<3>(f) == vertices)
        area += cell->face(f)->measure();
  EXPECT_NEAR(sum(area), 64. * 2., 1e-10);
}

} // namespace
