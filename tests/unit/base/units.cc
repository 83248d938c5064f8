// Numbers with units.

#include <thelma/base/error.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>

#include <gtest/gtest.h>

using namespace thelma;

namespace
{

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
  for (const char* word : {"temperature", "voltage"})
    EXPECT_TRUE(contains(complaint(Quantity("kV"), "353 K"), word));
  for (const char* word : {"pressure", "length"})
    EXPECT_TRUE(contains(complaint(Quantity("mm"), "3 kPa"), word));
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
