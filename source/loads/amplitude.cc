#include <thelma/base/error.h>
#include <thelma/base/quantity.h>
#include <thelma/loads/amplitude.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace thelma
{

Amplitude::Amplitude(const std::string& place, const std::string& text) : place(place), text(text)
{
  const bool is_table =
      text.find(':') != std::string::npos && text.find('?') == std::string::npos; // a ? b : c
  if (!is_table) {
    formula = std::make_shared<Formula<1>>(place, text, "t");
    return;
  }
  try {
    for (const std::string& row : dealii::Utilities::split_string_list(text)) {
      const std::size_t colon = std::min(row.find(':'), row.size() - 1);
      const double time = Quantity("s").value(row.substr(0, colon)),
                   value = Quantity("1").value(row.substr(colon + 1));
      if (!rows.emplace(time, value).second)
        throw InputError("the time " + as_text(time) + " s is given twice");
      if (rows.rbegin()->first != time)
        throw InputError("the time " + as_text(time) + " s comes after a later one");
    }
  } catch (const InputError& error) {
    throw InputError(place + ": cannot read the table '" + text +
                     "'; write `time: value, time: value` with times in s: " + error.what());
  }
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
