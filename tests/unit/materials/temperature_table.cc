#include "support.h"

#include <thelma/base/error.h>

/// Tables of values at temperatures: through their rows, monotone, with a continuous slope, no
/// number outside, and how they are written; and the polynomials that are written in their place.
namespace thelma
{
namespace
{

using namespace material_tests;

const std::vector<double> rows{273., 283., 293., 300., 353., 360., 370.},
    values{0.085, 0.07, 0.0566, 0.0566, 0.02, 0.03, 0.0299};

TEST(MaterialsTemperatureTable, PassesItsRows)
{
  const TemperatureTable table(rows, values);
  for (std::size_t k = 0; k < rows.size(); ++k)
    EXPECT_NEAR(table.value(rows[k]), values[k], 1e-16);
}

TEST(MaterialsTemperatureTable, IsMonotoneBetweenRows)
{
  const TemperatureTable table(rows, values);
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    double before = values[k];
    for (unsigned int i = 1; i <= 1000; ++i) {
      const double now = table.value(rows[k] + (rows[k + 1] - rows[k]) * i / 1000.);
      EXPECT_GE((now - before) * (values[k + 1] - values[k]), -1e-16) << rows[k] << " " << i;
      before = now;
    }
  }
}

/// One ulp aside of a row the next piece has the same value and slope.
TEST(MaterialsTemperatureTable, IsSmoothAcrossRows)
{
  const TemperatureTable table(rows, values);
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
    const double before = std::nextafter(rows[k], 0.);
    EXPECT_NEAR(table.value(before), table.value(rows[k]), 1e-15);
    EXPECT_NEAR(table.slope(before), table.slope(rows[k]), 1e-15);
  }
}

TEST(MaterialsTemperatureTable, DerivativesAreDifferences)
{
  const TemperatureTable table(rows, values);
  constexpr double h = 1e-3;
  for (double theta = 273.05; theta < 370.; theta += 0.1) {
    EXPECT_NEAR(table.slope(theta), (table.value(theta + h) - table.value(theta - h)) / (2. * h),
                1e-8);
    const bool has_row = std::any_of(
        rows.begin(), rows.end(), [&](const double row) { return std::abs(row - theta) < 2. * h; });
    const double bend = (table.slope(theta + h) - table.slope(theta - h)) / (2. * h);
    EXPECT_TRUE(has_row || std::abs(table.curvature(theta) - bend) < 1e-10) << theta;
  }
}

/// A parabola's slopes at unequal rows, by hand: harmonic means inside, the parabola's at the ends.
TEST(MaterialsTemperatureTable, SlopesByHand)
{
  const TemperatureTable table({300., 301., 303.}, {0., 1., 9.}); // secants 1 and 4
  EXPECT_DOUBLE_EQ(table.slope(301.), 9. / (5. / 1. + 4. / 4.));
  EXPECT_DOUBLE_EQ(table.slope(300.), 0.);
  EXPECT_DOUBLE_EQ(table.slope(303.), (5. * 4. - 2. * 1.) / 3.);
  const TemperatureTable line({300., 320.}, {1., 5.});
  EXPECT_DOUBLE_EQ(line.value(305.), 2.);
  EXPECT_DOUBLE_EQ(line.slope(320.), 0.2);
  EXPECT_EQ(line.curvature(310.), 0.);
}

TEST(MaterialsTemperatureTable, NoNumberOutside)
{
  const TemperatureTable table(rows, values);
  for (const double theta : {0., 272.9, 370.1, double(NAN)}) {
    EXPECT_TRUE(std::isnan(table.value(theta)));
    EXPECT_TRUE(std::isnan(table.slope(theta)));
    EXPECT_TRUE(std::isnan(table.curvature(theta)));
    EXPECT_FALSE(table.has(theta));
  }
  EXPECT_TRUE(table.has(370. + 1e-9)) << "rounding of a wall";
  Lanes theta = 300.;
  theta.set(1, 380.);
  EXPECT_TRUE(std::isnan(table.value(theta)[1]));
  EXPECT_FALSE(std::isnan(table.value(theta)[0]));
}

TEST(MaterialsTemperatureTable, LanesLookUpTheirOwnRows)
{
  const TemperatureTable table(rows, values);
  for (double first = 273.; first < 355.; first += 0.7) {
    Lanes theta;
    for (unsigned int lane = 0; lane < Lanes::n; ++lane)
      theta.set(lane, first + 2. * lane);
    for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
      EXPECT_NEAR(table.value(theta)[lane], table.value(theta[lane]), 1e-16);
      EXPECT_NEAR(table.slope(theta)[lane], table.slope(theta[lane]), 1e-16);
      EXPECT_NEAR(table.curvature(theta)[lane], table.curvature(theta[lane]), 1e-16);
    }
  }
}

/// The polynomial against Sacado.
TEST(MaterialsTemperatureLaw, DerivativesAreExact)
{
  using Ad1 = Sacado::Fad::SFad<double, 1>;
  // A constant, the shear modulus of the paper (section 4) in full digits, and a longer law.
  const std::vector<std::vector<double>> laws = {
      {3.98e-5}, {1.5180 / 3., -1.078 / 3., 0.2001 / 3.}, {0.3, -0.2, 0.1, 0.05, -0.01}};
  for (const std::vector<double>& coefficients : laws) {
    const TemperatureLaw law(coefficients);
    RandomStates random;
    WorstErrors errors;
    for (unsigned int n = 0; n < 1000; ++n) {
      const double theta = random.uniform(250., 400.), x = 1000. / theta;
      double sum = 0.;
      for (std::size_t m = 0; m < coefficients.size(); ++m)
        sum += coefficients[m] * std::pow(x, m);
      const Ad1 theta_ad(1, 0, theta), value = law.value(theta_ad), slope = law.slope(theta_ad);
      const double scale = std::abs(coefficients[0]);
      errors.add("value", law.value(theta), sum, scale);
      errors.add("slope", law.slope(theta), value.dx(0), scale / theta);
      errors.add("curvature", law.curvature(theta), slope.dx(0), scale / (theta * theta));
    }
    errors.expect_below(1e-12);
  }
}

std::string complaint(const std::function<void()>& action)
{
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The material as a parameter file has it.
std::string complaint_about(const std::string& entry)
{
  const ParameterFile file = ParameterFile::from_text(
      "subsection Regions\n set Materials = all: rubber\nend\nsubsection Materials\n"
      " subsection rubber\n  set " +
      entry + "\n end\nend\n");
  return complaint([&]() {
    MaterialLibrary library(file);
    dealii::ParameterHandler prm;
    library.declare(prm);
    file.read(prm);
    library.check(310.);
  });
}

TEST(MaterialsTemperatureTable, IsReadWithUnits)
{
  const ParameterFile file = ParameterFile::from_text(
      "subsection Regions\n set Materials = all: rubber\nend\nsubsection Materials\n"
      " subsection rubber\n"
      "  set Shear modulus = 20 degC: 60 kPa, 353.15: 0.02\n"
      "  set Permittivity = 293: 4.2e-11 F/m, 313 K: 4e-5\n end\nend\n");
  MaterialLibrary library(file);
  dealii::ParameterHandler prm;
  library.declare(prm);
  file.read(prm);
  const Material& material = library.of_region("all");
  EXPECT_NEAR(material.shear_modulus(323.15), 0.04, 1e-15);
  EXPECT_NEAR(material.permittivity(303.), 4.1e-5, 1e-19);
}

TEST(MaterialsTemperatureTable, MistakesAreNamed)
{
  const std::map<std::string, std::string> cases = {
      {"Shear modulus = 273: 0.07, 300: 0.05", "without the 310 K of Temperature/Value"},
      {"Shear modulus = 300: 0.07, 320: 0.05", "without the 293 K of Reference temperature"},
      {"Shear modulus = 320: 0.07, 300: 0.05", "in rising order"},
      {"Shear modulus = 300: 0.07, 300: 0.05", "write each one once"},
      {"Shear modulus = 300: 0.07", "two temperatures or more"},
      {"Shear modulus = 273: 0.07, 0.05", "temperatures for some values only"},
      {"Shear modulus = 273 V: 0.07, 300: 0.05", "must be a temperature"},
      {"Shear modulus = 273: 0.07 K, 300: 0.05", "must be a pressure"},
      {"Shear modulus = 273: , 300: 0.05", "is not a number"},
      {"Shear modulus = : 1, 300: 0.05", "is not a number"},
      {"Shear modulus = 273: 0.07, 300: -0.05, 350: -0.06", "must be positive"}};
  for (const auto& [entry, words] : cases) {
    const std::string sentence = complaint_about(entry);
    EXPECT_NE(sentence.find(words), std::string::npos) << entry << " gives " << sentence;
    EXPECT_NE(sentence.find("Shear modulus"), std::string::npos) << sentence;
  }
  EXPECT_EQ(complaint_about("Shear modulus = 273: 0.07, 350: 0.05"), "");
}

} // namespace
} // namespace thelma
