// Fields of several ranks in common files, whichever rank fails.

#include "marks.h"
#include "scene.h"

#include <thelma/base/error.h>
#include <thelma/output/vtu_files.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace
{

using namespace thelma_test;
using dealii::Utilities::MPI::n_mpi_processes;
using dealii::Utilities::MPI::this_mpi_process;

class DealtOutFields : public testing::Test
{
protected:
  void SetUp() override
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "fields.XXXXXX").string();
    if (is_first) {
      ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    }
    folder = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, pattern);
    files.attach_dof_handler(scene.layout.dof_handler());
    files.add_data_vector(scene.state.x, "u");
    files.build_patches();
  }
  void TearDown() override
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (is_first)
      std::filesystem::remove_all(folder);
  }

  /// How often @p word occurs in a file of the folder.
  unsigned int count(const std::string& file, const std::string& word) const
  {
    std::ifstream stream(folder + "/" + file);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    unsigned int n = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
      ++n;
    return n;
  }

  const bool is_first = this_mpi_process(MPI_COMM_WORLD) == 0;
  const unsigned int n_ranks = n_mpi_processes(MPI_COMM_WORLD);
  TestScene<3> scene{"subsection Mesh\n set File = meshes/bilayer.geo\n"
                     " set Parameters = L: 4, W: 2, H: 2, n1: 2, n2: 2, n3: 4\nend\n"
                     "subsection Regions\n set Materials = active: elastomer, passive: elastomer\n"
                     " set Passive = active, passive\nend\n"
                     "subsection Supports\n set Fixed = x3_min: u1 u2 u3\nend\n"};
  VtuFiles<3> files;
  std::string folder;
};
ON_TWO_RANKS(DealtOutFields);

TEST_F(DealtOutFields, OfAllRanksMakeOneFile)
{
  EXPECT_EQ(files.write(folder, "all", MPI_COMM_WORLD), "all.pvtu");
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(count("all.pvtu", "<Piece "), 1);
  EXPECT_EQ(count("all.0.vtu", "<Piece "), n_ranks);
  EXPECT_EQ(count("all.0.vtu", "</VTKFile>"), 1);
}

TEST_F(DealtOutFields, MakeAFileForEveryGroup)
{
  files.write(folder, "each", MPI_COMM_WORLD, 1);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(count("each.pvtu", "<Piece "), n_ranks);
  for (unsigned int rank = 0; rank < n_ranks; ++rank)
    EXPECT_EQ(count("each." + std::to_string(rank) + ".vtu", "<Piece "), 1);
}

TEST_F(DealtOutFields, FailOnAllRanksAlike)
{
  const std::string last = "each." + std::to_string(n_ranks - 1) + ".vtu";
  if (is_first)
    std::filesystem::create_directory(folder + "/" + last);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_THROW(files.write(folder, "each", MPI_COMM_WORLD, 1), WriteError);
}

} // namespace
