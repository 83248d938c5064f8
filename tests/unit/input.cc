// Reading parameter files: units, misspellings, all problems at once, and damaged files.

#include <thelma/application/simulation.h>
#include <thelma/base/error.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/base/units.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

using namespace thelma;

namespace
{

/// Complaints about a file of this text.
std::vector<std::string> complaints(const std::string& text)
{
  try {
    is_finished(ParameterFile::from_text(text), "nowhere");
  } catch (const InputError& error) {
    return error.sentences();
  }
  return {};
}

std::string complaint(const Quantity& quantity, const std::string& text)
{
  try {
    quantity.value(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
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

// The factors are those of the SI brochure, worked out by hand.
TEST(Units, AreConverted)
{
  const auto value = [](const char* unit, const char* text) { return Quantity(unit).value(text); };
  EXPECT_DOUBLE_EQ(value("kV", "18.2 kV"), 18.2);
  EXPECT_DOUBLE_EQ(value("kV", "18200V"), 18.2);
  EXPECT_DOUBLE_EQ(value("kV", "18.2"), 18.2);
  EXPECT_DOUBLE_EQ(value("K", "80 degC"), 353.15);
  EXPECT_DOUBLE_EQ(value("K", "80 \u00b0C"), 353.15);
  EXPECT_DOUBLE_EQ(value("K", "353 K"), 353.);
  EXPECT_DOUBLE_EQ(value("mm", "20 um"), 0.02);
  EXPECT_DOUBLE_EQ(value("mm", "20 \u00b5m"), 0.02);
  EXPECT_DOUBLE_EQ(value("MPa", "56 kPa"), 0.056);
  EXPECT_DOUBLE_EQ(value("MPa", "0.056 N/mm^2"), 0.056);
  EXPECT_DOUBLE_EQ(value("N/kV^2", "3.98e-11 F/m"), 3.98e-5);
  EXPECT_DOUBLE_EQ(value("MJ/(m^3 K)", "1.92 MPa/K"), 1.92);
  EXPECT_DOUBLE_EQ(value("W/(m K)", "0.16 N/(s K)"), 0.16);
  EXPECT_DOUBLE_EQ(value("mW/(mm^2 K)", "20 W/m^2/K"), 0.02);
  EXPECT_DOUBLE_EQ(value("1/K", "1.8e-4 K^-1"), 1.8e-4);
  EXPECT_DOUBLE_EQ(value("kV/mm", "51 MV/m"), 51.);
  EXPECT_DOUBLE_EQ(value("s", "2 min"), 120.);
  EXPECT_DOUBLE_EQ(value("uC", "3 nC"), 0.003);
  EXPECT_EQ(value("K", "353.15"), 353.15) << "a plain number keeps every digit";
}

TEST(Units, WrongDimensionsAreNamed)
{
  EXPECT_TRUE(
      contains(complaint(Quantity("kV"), "353 K"), "is a temperature but must be a voltage"));
  EXPECT_TRUE(contains(complaint(Quantity("mm"), "3 kPa"), "is a pressure but must be a length"));
  EXPECT_TRUE(contains(complaint(Quantity("mm"), "3 furlong"), "'furlong'"));
  EXPECT_TRUE(contains(complaint(Quantity("mm"), "3 m^"), "not a unit"));
  EXPECT_TRUE(contains(complaint(Quantity("mm"), "3 (((m"), "not a unit"));
  EXPECT_TRUE(contains(complaint(Quantity("mm"), "nan"), "not a number"));
  EXPECT_TRUE(contains(complaint(Quantity("mm"), "1e999"), "not a number"));
  EXPECT_TRUE(contains(complaint(Quantity("K", 1.), "-300 degC"), "at least 1"));
  EXPECT_TRUE(contains(complaint(Quantity("K").of_difference(), "3 degC"), "difference"));
}

TEST(Units, ReachEntriesListsAndMaps)
{
  dealii::ParameterHandler prm;
  double thickness = 1.;
  std::vector<double> modulus{1.5180 / 3.};
  std::map<std::string, double> walls;
  add_quantity(prm, "Thickness", thickness, "h.", Quantity("mm", 1e-12));
  add_quantity(prm, "Modulus", modulus, "mu.", Quantity("MPa"));
  add_quantity(prm, "Walls", walls, "theta.", Quantity("K", 1.));
  ParameterFile::from_text("set Thickness = 20 um\nset Modulus = 56 kPa, -0.3\n"
                           "set Walls = inner: 80 degC, outer: 293\n")
      .read(prm);
  EXPECT_DOUBLE_EQ(thickness, 0.02);
  EXPECT_EQ(modulus, (std::vector<double>{0.056, -0.3}));
  EXPECT_EQ(walls, (std::map<std::string, double>{{"inner", 353.15}, {"outer", 293.}}));
  EXPECT_EQ(prm.get("Walls"), "inner: 353.15, outer: 293") << "what used.prm shows";
}

TEST(Input, MisspellingsAreRecognised)
{
  const std::vector<std::string> known{"Tolerance", "Iterations", "Reuse tangent"};
  EXPECT_EQ(closest("Tolerence", known), "Tolerance");
  EXPECT_EQ(closest("iteratoins", known), "Iterations");
  EXPECT_EQ(closest("Voltage", known), "");
}

TEST(Input, AllProblemsAreSaidAtOnceWithTheirLines)
{
  const std::vector<std::string> found = complaints("subsection Regions\n"
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
  EXPECT_TRUE(contains(found[0], ":4: unknown subsection 'Newtn'; did you mean 'Newton'?"));
  EXPECT_TRUE(contains(found[1], ":8, section Newton: unknown entry 'Tolerence'; did you mean "
                                 "'Tolerance'?"));
  EXPECT_TRUE(contains(found[2], ":9, section Newton, entry 'Iterations': the value is 'many' but "
                                 "must be an integer from 1 to 1000"));
  EXPECT_TRUE(contains(found[3], ":10, section Newton: unknown entry 'Film thickness'; it belongs "
                                 "to the section Loading"));
  EXPECT_TRUE(contains(found[4], ":12: the subsection 'Temperature' is not closed"));
  EXPECT_TRUE(contains(found[5], ":13, section Temperature, entry 'Value': '2 kV' is a voltage"));
  EXPECT_TRUE(contains(found[6], ":14: cannot read 'hello'"));
}

// deal.II's own listings take a dot in a name for a separator.
TEST(Input, NamesMayHaveDots)
{
  for (const std::string name : {"VHB 4910", "Elastosil 2030.1", "dotted."}) {
    const std::vector<std::string> found = complaints(
        "subsection Regions\n set Materials = film: " + name +
        "\nend\nsubsection Materials\n subsection " + name + "\n  set Gent limt = 80\n end\nend\n");
    ASSERT_EQ(found.size(), 1u) << name;
    EXPECT_TRUE(contains(found[0], "parameters:6, section Materials/" + name +
                                       ": unknown entry 'Gent limt'; known: Bulk modulus"))
        << found[0];
  }
}

// What has an effect only beside another choice.
TEST(Input, EntriesWithoutEffectAreTold)
{
  const auto told = [](const std::vector<Override>& changes) {
    const ParameterFile file(THELMA_SOURCE_DIR "/prm/verification/slab_heating.prm", changes);
    return joined(lines_of(check_scene(MPI_COMM_SELF, file, testing::TempDir()), "without effect"));
  };
  EXPECT_EQ(told({}), "");
  EXPECT_EQ(told({{{"Stepping"}, "Most steps", "5"},
                  {{"Linear solver"}, "Tolerance", "1e-7"},
                  {{"Linear solver"}, "Iterations", "9"},
                  {{"Mesh"}, "Imperfection shape", "x3; 0; 0"},
                  {{"Time"}, "Heat amplitude", "t"},
                  {{"Loading"}, "Film thickness", "2 mm"}}),
            "  without effect: Mesh/Imperfection shape, because Imperfection is 0\n"
            "  without effect: Time/Heat amplitude, because there is neither Heat/Flux nor "
            "Heat/Source\n"
            "  without effect: Loading/Film thickness, because every region is passive\n"
            "  without effect: Stepping/Most steps, because Continuation is not automatic\n"
            "  without effect: Linear solver/Iterations, Linear solver/Tolerance, because the "
            "solver is direct\n");
  EXPECT_EQ(told({{{"Mesh"}, "Imperfection", "0.1"}, {{"Mesh"}, "Imperfection shape", "x1; 0; 0"}}),
            "");
}

TEST(Input, EverySceneIsRead)
{
  for (const std::string& text : scenes())
    EXPECT_EQ(complaints(text), std::vector<std::string>());
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
    EXPECT_NO_THROW(complaints(text)) << text;
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
    const std::vector<std::string> found = complaints(joined(lines));
    EXPECT_FALSE(found.empty()) << joined(lines);
    if (!found.empty()) {
      EXPECT_TRUE(contains(joined(found), ":" + std::to_string(at + 1)))
          << joined(lines) << joined(found);
    }
  }
}
