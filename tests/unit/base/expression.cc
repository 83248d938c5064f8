#include <thelma/base/error.h>
#include <thelma/base/expression.h>

#include <gtest/gtest.h>

#include <limits>

namespace thelma
{
namespace
{

using J = Jet<double, 2>;

J value(const std::string& text, const double x, const double y)
{
  const Expression expression(text, {"x", "y"}, {{"a", 2.}, {"k_1", 0.5}});
  return expression(std::array<J, 2>{{J::variable(x, 0), J::variable(y, 1)}});
}

TEST(BaseExpression, ReadsAsOneDoes)
{
  const std::vector<std::pair<std::string, double>> cases = {{"1 + 2*3", 7.},
                                                             {"(1 + 2)*3", 9.},
                                                             {"8/4/2", 1.},
                                                             {"2 - 3 - 4", -5.},
                                                             {"-2^2", -4.},
                                                             {"2^-1", 0.5},
                                                             {"2^3^2", 512.},
                                                             {"x - y - 1", -1.5},
                                                             {"1 - x", -1.},
                                                             {"2/x", 1.},
                                                             {"x/y/a", 0.4},
                                                             {"-x^2", -4.},
                                                             {"a*x + k_1*y", 5.25},
                                                             {"x^2*y", 10.},
                                                             {"1.5e1 + .5", 15.5},
                                                             {"exp(log(x))", 2.},
                                                             {"sqrt(x + 2)", 2.},
                                                             {"(x + y)*(x - y)", -2.25},
                                                             {"x - (y - (x - y))", -1.},
                                                             {"+x", 2.},
                                                             {"((x))", 2.}};
  for (const auto& [text, exact] : cases)
    EXPECT_NEAR(value(text, 2., 2.5).value, exact, 1e-13) << text;
}

/// By hand.
TEST(BaseExpression, DerivativesAreExact)
{
  const double x = 0.7, y = 1.3;
  const J f = value("exp(a*x)*log(y) + x^3/y - sqrt(y)*x", x, y);
  const double e = std::exp(2. * x), l = std::log(y), s = std::sqrt(y);
  EXPECT_NEAR(f.value, e * l + x * x * x / y - s * x, 1e-14);
  EXPECT_NEAR(f.first[0], 2. * e * l + 3. * x * x / y - s, 1e-14);
  EXPECT_NEAR(f.first[1], e / y - x * x * x / (y * y) - x / (2. * s), 1e-14);
  EXPECT_NEAR(f.seconds[J::second(0, 0)], 4. * e * l + 6. * x / y, 1e-13);
  EXPECT_NEAR(f.seconds[J::second(0, 1)], 2. * e / y - 3. * x * x / (y * y) - 1. / (2. * s), 1e-13);
  EXPECT_NEAR(f.seconds[J::second(1, 1)],
              -e / (y * y) + 2. * x * x * x / (y * y * y) + x / (4. * y * s), 1e-13);
}

/// Whole exponents allow a base of zero and below; nothing else does.
TEST(BaseExpression, AtZero)
{
  const J square = value("(x - 1)^2", 1., 0.), cube = value("(x - 3)^3", 1., 0.);
  EXPECT_EQ(square.value, 0.);
  EXPECT_EQ(square.first[0], 0.);
  EXPECT_EQ(square.seconds[0], 2.);
  EXPECT_EQ(cube.value, -8.);
  EXPECT_EQ(cube.seconds[0], -12.);
  EXPECT_EQ(value("x^1", 0., 0.).seconds[0], 0.);
  EXPECT_TRUE(std::isnan(value("x^0.5", -1., 0.).value));
  EXPECT_TRUE(std::isnan(value("log(x)", -1., 0.).first[0]));
}

TEST(BaseExpression, MistakesAreNamed)
{
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"x + z", "unknown name 'z'"},
      {"x + logg(y)", "did you mean 'log'"},
      {"x + ", "is missing at its end"},
      {"(x + y", "not closed"},
      {"x y", "from 'y' on"},
      {"x + * y", "'* y' is not expected"},
      {"x^y", "exponent depends on x, y"},
      {"log x", "argument in parentheses"},
      {"", "is missing"},
      {"x)", "from ')' on"}};
  for (const auto& [text, words] : cases)
    try {
      value(text, 1., 1.);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  std::string deep = "x";
  for (unsigned int i = 0; i < 20; ++i)
    deep = "y*exp(x + y*(" + deep + "))";
  EXPECT_THROW(value(deep, 1., 1.), InputError);
  EXPECT_THROW(value(std::string(100000, '('), 1., 1.), InputError);
  EXPECT_THROW(value(std::string(100000, '-'), 1., 1.), InputError);
}

} // namespace
} // namespace thelma
