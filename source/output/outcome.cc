#include <thelma/base/error.h>
#include <thelma/base/formula.h>
#include <thelma/base/parameters.h>
#include <thelma/output/outcome.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace thelma
{

void Outcome::end(const EndReason why, const std::string& details)
{
  ended = why;
  code = ending_of(why).code;
  reason = ending_of(why).sentence + details;
}

std::string Outcome::summary() const
{
  std::ostringstream text;
  text << (reason.empty() ? name() : reason);
  if (is_lasting())
    text << "; " << steps << " steps, " << effort.iterations << " Newton iterations, "
         << std::setprecision(3) << seconds << " s";
  return text.str();
}

void Expectations::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Expectations"});
  prm.add_parameter("Final values", values,
                    "Expected values in the last row of the curve, as `column: expression`; an "
                    "expression may contain theta, the temperature in K.",
                    Map(Anything(), Anything(), 0, 100));
  prm.add_parameter("Relative tolerance", tolerance, "Relative tolerance of the expected values.",
                    Double(0., 1.));
}

void Expectations::setup(const std::vector<std::string>& columns, const double theta)
{
  const std::string place = "section Expectations, entry 'Final values'";
  for (const auto& [column, expression] : values) {
    if (std::find(columns.begin(), columns.end(), column) == columns.end())
      throw InputError(place + ": the curve has no column '" + column + "'" +
                       did_you_mean(column, columns));
    const Formula<1> formula(place + ", " + column, expression, "theta");
    expected[column] = formula(dealii::Point<1>(theta));
    if (!std::isfinite(expected[column]))
      throw InputError(place + ", " + column + ": '" + expression + "' is " +
                       as_text(expected[column]) + " at " + as_text(theta) +
                       " K; write an expression that is finite there");
  }
}

std::string Expectations::check(const Curve& curve) const
{
  for (const auto& [column, value] : expected) {
    const double found = *curve.newest(column);
    if (!(std::abs(found - value) <= tolerance * std::abs(value))) {
      std::ostringstream text;
      text.precision(8);
      text << column << " is " << found << " but " << value << " was expected (relative "
           << "tolerance " << tolerance << ")";
      return text.str();
    }
  }
  return "";
}

} // namespace thelma
