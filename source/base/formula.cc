#include <thelma/base/error.h>
#include <thelma/base/formula.h>

#include <algorithm>
#include <iostream>
#include <regex>
#include <sstream>

namespace thelma
{
namespace
{

/// The parser's message among what deal.II says.
std::string reason(const std::string& noise)
{
  std::smatch message;
  const bool found =
      std::regex_search(noise, message, std::regex("Message: +<?([^\n]+?)\\.?>? *\n"));
  return found ? message[1].str() : "invalid expression";
}

} // namespace

template <int n>
Formula<n>::Formula(const std::string& place, const std::string& expression,
                    const std::string& variables)
{
  std::ostringstream parser_noise; // deal.II writes the parser's complaint to cerr
  auto* const cerr = std::cerr.rdbuf(parser_noise.rdbuf());
  std::string problem;
  try {
    parser.initialize(variables, expression, {{"pi", dealii::numbers::PI}},
                      std::count(variables.begin(), variables.end(), ',') == n);
    parser.value(dealii::Point<n>()); // the first value is what parses
  } catch (const dealii::ExceptionBase&) {
    problem = reason(parser_noise.str());
  }
  std::cerr.rdbuf(cerr);
  if (!problem.empty())
    throw InputError((place.empty() ? "" : place + ": ") + "cannot evaluate '" + expression +
                     "' (" + problem + "); write an expression of " + variables);
}

template class Formula<1>;
template class Formula<2>;
template class Formula<3>;

} // namespace thelma
