#pragma once

#include <thelma/base/jet.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace thelma
{

/// A formula that a parameter file brings along, for any number type: with Jet it gives exact
/// derivatives, with Lanes several points at once. Sums, products, quotients, powers with exponents
/// that do not vary, `exp`, `log` (natural), `sqrt`.
class Expression
{
public:
  /// Knows the @p variables by these names, and @p numbers. Throws InputError with a sentence
  /// without place.
  Expression(const std::string& text, const std::vector<std::string>& variables,
             const std::map<std::string, double>& numbers);

  /// At these values of the variables.
  template <typename Number, std::size_t n>
  Jet<Number, n> operator()(const std::array<Jet<Number, n>, n>& variables) const
  {
    std::array<Jet<Number, n>, deepest> stack;
    std::size_t top = 0; // the first free place
    for (const Step& step : steps)
      switch (step.what) {
      case What::number:
        stack[top++] = Jet<Number, n>::constant(step.number);
        break;
      case What::variable:
        stack[top++] = variables[step.variable];
        break;
      case What::sum:
        --top;
        stack[top - 1] = stack[top - 1] + stack[top];
        break;
      case What::product:
        --top;
        stack[top - 1] = stack[top - 1] * stack[top];
        break;
      case What::shift:
        stack[top - 1].value += step.number;
        break;
      case What::scale:
        stack[top - 1] =
            stack[top - 1].through(Number(step.number * stack[top - 1].value), step.number, 0.);
        break;
      case What::power:
        stack[top - 1] = power(stack[top - 1], step.number);
        break;
      case What::exp:
        stack[top - 1] = exp(stack[top - 1]);
        break;
      case What::log:
        stack[top - 1] = log(stack[top - 1]);
        break;
      }
    return stack[0];
  }

private:
  friend class ExpressionReader;
  static constexpr std::size_t deepest = 16;

  /// In the order of computation; operands are the newest results, and sums and products of two.
  enum class What { number, variable, sum, product, shift, scale, power, exp, log };
  struct Step {
    What what;
    double number = 0.;
    unsigned int variable = 0;
  };

  std::vector<Step> steps;
};

} // namespace thelma
