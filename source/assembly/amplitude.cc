#include <thelma/assembly/amplitude.h>
#include <thelma/base/error.h>

#include <deal.II/base/patterns.h>

namespace thelma
{

Amplitude::Amplitude(const std::string& place, const std::string& text)
{
  using namespace dealii::Patterns;
  const Map table(Double(), Double(), 1);
  if (text.find(':') == std::string::npos)
    formula = std::make_shared<Formula<1>>(place, text, "t");
  else if (table.match(text))
    rows = Tools::Convert<std::map<double, double>>::to_value(text, table);
  else
    throw InputError(place + ": cannot read the table '" + text +
                     "'; write `time: value, time: value` with times in s");
}

double Amplitude::operator()(const double time) const
{
  if (formula)
    return (*formula)(dealii::Point<1>(time));
  const auto after = rows.upper_bound(time);
  if (after == rows.begin())
    return after->second;
  const auto before = std::prev(after);
  if (after == rows.end())
    return before->second;
  return before->second +
         (after->second - before->second) * (time - before->first) / (after->first - before->first);
}

} // namespace thelma
