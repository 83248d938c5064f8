// A sound checkpoint is there whatever happens to the newest one.

#include <thelma/base/error.h>
#include <thelma/output/checkpoints.h>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sys/resource.h>

namespace
{

using namespace thelma;

class CheckpointFiles : public testing::Test
{
protected:
  void SetUp() override
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "checkpoints.XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// What a new process finds.
  std::string found()
  {
    damaged.clear();
    return Checkpoints(folder).read(damaged).value_or("none");
  }
  std::string file(const int place) const
  {
    return folder + "/checkpoint." + std::to_string(place);
  }

  static std::string content(const std::string& name)
  {
    std::ifstream stream(name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  static void put(const std::string& name, const std::string& text)
  {
    std::ofstream(name, std::ios::binary) << text;
  }

  std::string folder;
  std::vector<std::string> damaged;
};

TEST_F(CheckpointFiles, TheLastTwoAreKept)
{
  EXPECT_EQ(found(), "none");
  Checkpoints checkpoints(folder);
  EXPECT_FALSE(checkpoints.has_any());
  for (const char* text : {"first", "second", "third"}) {
    checkpoints.write(text);
    EXPECT_EQ(found(), text);
    EXPECT_TRUE(damaged.empty());
  }
  std::filesystem::remove(file(0));
  EXPECT_EQ(found(), "second");
  Checkpoints(folder).write("fourth, by another process");
  EXPECT_EQ(found(), "fourth, by another process");
  EXPECT_NE(content(file(1)).find("second"), std::string::npos);
  checkpoints.remove();
  EXPECT_EQ(found(), "none");
}

TEST_F(CheckpointFiles, ADamagedOneIsFoundOut)
{
  Checkpoints checkpoints(folder);
  checkpoints.write("older");
  checkpoints.write(std::string(300, '\0'));
  const std::string sound = content(file(1));
  for (std::size_t i = 0; i < sound.size(); ++i) {
    std::string flipped = sound;
    flipped[i] = static_cast<char>(flipped[i] ^ 16);
    put(file(1), flipped);
    ASSERT_EQ(found(), "older") << "byte " << i;
    ASSERT_EQ(damaged, std::vector<std::string>{file(1)});
    put(file(1), sound.substr(0, i));
    ASSERT_EQ(found(), "older") << "cut to " << i << " bytes";
  }
  put(file(1), sound + " ");
  EXPECT_EQ(found(), "older");
  put(file(0), "");
  EXPECT_EQ(found(), "none");
  EXPECT_EQ(damaged.size(), 2u);
}

/// The next one then takes the place of the damaged one, not of the sound one.
TEST_F(CheckpointFiles, TheSoundOneStays)
{
  Checkpoints(folder).write("older");
  Checkpoints(folder).write("newer");
  put(file(1), "damaged");
  Checkpoints(folder).write("newest");
  EXPECT_EQ(found(), "newest");
  EXPECT_TRUE(damaged.empty());
  EXPECT_NE(content(file(0)).find("older"), std::string::npos);
}

TEST_F(CheckpointFiles, AFullDiskKeepsThePreviousOnes)
{
  Checkpoints checkpoints(folder);
  checkpoints.write("older");
  checkpoints.write("newer");
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit tight{1000, limit.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &tight);
  EXPECT_THROW(checkpoints.write(std::string(100000, 'x')), WriteError);
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(found(), "newer");
  EXPECT_TRUE(damaged.empty());
  EXPECT_FALSE(std::filesystem::exists(folder + "/checkpoint.part"));
  checkpoints.write("newest");
  EXPECT_EQ(found(), "newest");
}

} // namespace
