// curve.csv while it grows: what stands on the disk is what a whole new file would be.

#include <thelma/base/error.h>
#include <thelma/output/curve.h>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sys/resource.h>

namespace
{

using namespace thelma;

class CurveFile : public testing::Test
{
protected:
  void SetUp() override
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "curve.XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder = pattern;
    file = folder + "/curve.csv";
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::string content() const
  {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::string folder, file;
  Curve curve{{"step", "load"}};
};

TEST_F(CurveFile, GrowsByItsRows)
{
  std::string wanted = "step,load,event\n";
  for (int n = 0; n < 4; ++n) {
    curve.add({double(n), 0.5});
    curve.write(file);
    wanted += std::to_string(n) + ",0.5,\n";
    EXPECT_EQ(content(), wanted);
  }
  curve.write(file);
  EXPECT_EQ(content(), wanted) << "nothing is new";
  curve.set_event("pull-in");
  curve.write(file);
  EXPECT_EQ(content(), wanted.substr(0, wanted.size() - 1) + "pull-in\n");
}

TEST_F(CurveFile, AnEventOfAnOldRowIsNotForgotten)
{
  curve.add({0., 0.});
  curve.write(file);
  curve.set_event("bifurcation");
  curve.add({1., 1.});
  curve.write(file);
  EXPECT_EQ(content(), "step,load,event\n0,0,bifurcation\n1,1,\n");
}

TEST_F(CurveFile, ALostFileIsWrittenAnew)
{
  curve.add({0., 0.});
  curve.write(file);
  std::filesystem::remove(file);
  curve.add({1., 1.});
  curve.write(file);
  EXPECT_EQ(content(), "step,load,event\n0,0,\n1,1,\n");
}

TEST_F(CurveFile, AFullDiskKeepsWholeRows)
{
  curve.add({0., 0.});
  curve.write(file);
  const std::string before = content();
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit tight{before.size() + 2, limit.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &tight);
  curve.add({1., 1.});
  EXPECT_THROW(curve.write(file), WriteError);
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(content(), before);
  curve.write(file);
  EXPECT_EQ(content(), before + "1,1,\n");
}

} // namespace
