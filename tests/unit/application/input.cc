// Reading parameter files: misspellings, all problems at once, and damaged files.

#include <thelma/application/run_scene.h>
#include <thelma/base/error.h>
#include <thelma/base/parameters.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

using namespace thelma;

namespace
{

/// InputErrors about a file of this text.
std::vector<std::string> errors_in(const std::string& text)
{
  try {
    is_finished(ParameterFile::from_text(text), "nowhere");
  } catch (const InputError& error) {
    return error.sentences();
  }
  return {};
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// Places, names and remedies.
void expect_words(const std::string& sentence, const std::vector<std::string>& words)
{
  for (const std::string& word : words)
    EXPECT_TRUE(contains(sentence, word)) << sentence << "\nhas no " << word;
}

std::vector<std::string> scenes()
{
  std::vector<std::string> texts;
  for (const char* folder : {"/prm", "/prm/hard", "/prm/verification"})
    for (const auto& file :
         std::filesystem::directory_iterator(std::string(THELMA_SOURCE_DIR) + folder))
      if (file.path().extension() == ".prm") {
        std::stringstream text;
        text << std::ifstream(file.path()).rdbuf();
        texts.push_back(text.str());
      }
  return texts;
}

/// Those that have the word.
std::vector<std::string> lines_of(const std::string& text, const std::string& word = "")
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (contains(line, word))
      lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines)
    text += line + "\n";
  return text;
}

} // namespace

TEST(Input, MisspellingsAreRecognised)
{
  const std::vector<std::string> known{"Tolerance", "Iterations", "Reuse tangent"};
  EXPECT_EQ(closest("Tolerence", known), "Tolerance");
  EXPECT_EQ(closest("iteratoins", known), "Iterations");
  EXPECT_EQ(closest("Voltage", known), "");
}

TEST(Input, AllProblemsAreSaidAtOnceWithTheirLines)
{
  const std::vector<std::string> found = errors_in("subsection Regions\n"
                                                   "  set Materials = film: elastomer\n"
                                                   "end\n"
                                                   "subsection Newtn\n"
                                                   "  set Tolerance = 1\n"
                                                   "end\n"
                                                   "subsection Newton\n"
                                                   "  set Tolerence = 1\n"
                                                   "  set Iterations = many\n"
                                                   "  set Film thickness = 1\n"
                                                   "end\n"
                                                   "subsection Temperature\n"
                                                   "  set Value = 2 kV\n"
                                                   "  hello\n");
  ASSERT_EQ(found.size(), 7u);
  expect_words(found[0], {":4", "'Newtn'", "'Newton'"});
  expect_words(found[1], {":8", "section Newton", "'Tolerence'", "'Tolerance'"});
  expect_words(found[2], {":9", "section Newton", "'Iterations'", "'many'", "1 to 1000"});
  expect_words(found[3], {":10", "section Newton", "'Film thickness'", "section Loading"});
  expect_words(found[4], {":12", "'Temperature'", "closed"});
  expect_words(found[5], {":13", "section Temperature", "'Value'", "'2 kV'", "voltage"});
  expect_words(found[6], {":14", "'hello'"});
}

// deal.II's own listings take a dot in a name for a separator.
TEST(Input, NamesMayHaveDots)
{
  for (const std::string name : {"VHB 4910", "Elastosil 2030.1", "dotted."}) {
    const std::vector<std::string> found = errors_in(
        "subsection Regions\n set Materials = film: " + name +
        "\nend\nsubsection Materials\n subsection " + name + "\n  set Gent limt = 80\n end\nend\n");
    ASSERT_EQ(found.size(), 1u) << name;
    expect_words(found[0], {":6", "section Materials/" + name, "'Gent limt'", "Bulk modulus"});
  }
}

// What has an effect only beside another choice.
TEST(Input, EntriesWithoutEffectAreTold)
{
  const auto told = [](const std::vector<Override>& changes) {
    const ParameterFile file(THELMA_SOURCE_DIR "/prm/verification/slab_heating.prm", changes);
    return lines_of(check_scene(MPI_COMM_SELF, file, testing::TempDir()), "without effect");
  };
  EXPECT_TRUE(told({}).empty());
  const std::vector<std::string> found = told({{{"Stepping"}, "Most steps", "5"},
                                               {{"Linear solver"}, "Tolerance", "1e-7"},
                                               {{"Linear solver"}, "Iterations", "9"},
                                               {{"Mesh"}, "Imperfection shape", "x3; 0; 0"},
                                               {{"Time"}, "Heat amplitude", "t"},
                                               {{"Loading"}, "Film thickness", "2 mm"}});
  ASSERT_EQ(found.size(), 5u) << joined(found);
  expect_words(found[0], {"Mesh/Imperfection shape", "Imperfection is 0"});
  expect_words(found[1], {"Time/Heat amplitude", "Heat/Flux", "Heat/Source"});
  expect_words(found[2], {"Loading/Film thickness", "passive"});
  expect_words(found[3], {"Stepping/Most steps", "Continuation", "automatic"});
  expect_words(found[4], {"Linear solver/Iterations", "Linear solver/Tolerance", "direct"});
  EXPECT_TRUE(
      told({{{"Mesh"}, "Imperfection", "0.1"}, {{"Mesh"}, "Imperfection shape", "x1; 0; 0"}})
          .empty());
}

TEST(Input, EverySceneIsRead)
{
  for (const std::string& text : scenes())
    EXPECT_EQ(errors_in(text), std::vector<std::string>());
}

// Whatever happens to a file, reading it ends, with success or with sentences.
TEST(Input, SurvivesDamage)
{
  std::mt19937 random(1);
  const std::vector<std::string> texts = scenes();
  const auto below = [&](const std::size_t n) { return random() % n; };
  constexpr char damage[] = "\0\t\n\\#=:;,/'\"%${}()[]<>-+.e0129azAZ\xff\xc2";
  const std::string bytes(damage, sizeof(damage) - 1);
  for (unsigned int n = 0; n < 700; ++n) {
    std::string text = texts[below(texts.size())];
    for (unsigned int k = 0; k < 1 + n % 9; ++k) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
      case 0:
        text[at] = bytes[below(bytes.size())];
        break;
      case 1:
        text.erase(at, 1 + below(40));
        break;
      case 2:
        text.insert(at, text.substr(below(text.size()), below(60)));
        break;
      default:
        text.insert(at, 1 + below(3), bytes[below(bytes.size())]);
      }
    }
    EXPECT_NO_THROW(errors_in(text)) << text;
  }
}

// A fault that is one for certain is found.
TEST(Input, FindsEveryFault)
{
  std::mt19937 random(2);
  const std::vector<std::string> texts = scenes();
  for (unsigned int n = 0; n < 300; ++n) {
    std::vector<std::string> lines = lines_of(texts[random() % texts.size()]);
    const std::size_t at = random() % lines.size();
    std::string& line = lines[at];
    const std::size_t set = line.find("set "), opens = line.find("subsection ");
    if (set != std::string::npos && set == line.find_first_not_of(' '))
      line.insert(set + 4, "x");
    else if (opens == 0)
      line.insert(11, "x");
    else if (line == "end")
      line = "ende";
    else
      line = "neither " + line;
    const std::vector<std::string> found = errors_in(joined(lines));
    EXPECT_FALSE(found.empty()) << joined(lines);
    if (!found.empty()) {
      EXPECT_TRUE(contains(joined(found), ":" + std::to_string(at + 1)))
          << joined(lines) << joined(found);
    }
  }
}
