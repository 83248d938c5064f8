#include <thelma/base/error.h>
#include <thelma/base/formula.h>

#include <iostream>
#include <sstream>

namespace thelma
{

template <int n>
Formula<n>::Formula(const std::string& place, const std::string& expression,
                    const std::string& variables)
{
  std::ostringstream parser_noise; // deal.II writes the parser's complaint to cerr
  auto* const cerr = std::cerr.rdbuf(parser_noise.rdbuf());
  bool readable = true;
  try {
    parser.initialize(variables, expression, {{"pi", dealii::numbers::PI}});
    parser.value(dealii::Point<n>()); // the first value is what parses
  } catch (const dealii::ExceptionBase&) {
    readable = false;
  }
  std::cerr.rdbuf(cerr);
  if (!readable)
    throw InputError(place + ": cannot evaluate '" + expression + "'; write an expression of " +
                     variables);
}

template class Formula<1>;
template class Formula<3>;

} // namespace thelma
