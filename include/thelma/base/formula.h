#pragma once

#include <deal.II/base/function_parser.h>

#include <string>

namespace thelma
{

/// A muParser expression of n variables, and perhaps the time behind them, that a parameter file
/// brings along.
template <int n>
class Formula
{
public:
  /// @p variables: their names, separated by commas; `pi` is known beside them. Throws InputError,
  /// with @p place in the sentence if it is not empty, if the expression cannot be read.
  Formula(const std::string& place, const std::string& expression, const std::string& variables);

  double operator()(const dealii::Point<n>& x) const { return parser.value(x); }

  /// Of one that depends on the @p time.
  double at(const dealii::Point<n>& x, const double time)
  {
    parser.set_time(time);
    return parser.value(x);
  }

private:
  dealii::FunctionParser<n> parser;
};

} // namespace thelma
