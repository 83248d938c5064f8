#include <thelma/base/error.h>
#include <thelma/base/quantity.h>
#include <thelma/base/units.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <iomanip>
#include <regex>
#include <sstream>

namespace thelma
{
namespace
{

/// With so many digits that a number of a parameter file stays the same.
std::string text_of(const double number)
{
  std::ostringstream text;
  text << std::setprecision(15) << number;
  return text.str();
}

std::string text_of(const std::vector<double>& numbers)
{
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : ", ") + text_of(number);
  return text;
}

std::string text_of(const std::map<std::string, double>& numbers)
{
  std::string text;
  for (const auto& [name, number] : numbers)
    text += (text.empty() ? "" : ", ") + name + ": " + text_of(number);
  return text;
}

/// Unlike ParameterHandler::add_parameter without rounding the default to six digits.
template <typename Value>
void declare(dealii::ParameterHandler& prm, const std::string& entry, Value& value,
             const std::string& sentence, const dealii::Patterns::PatternBase& pattern)
{
  prm.declare_entry(entry, text_of(value), pattern, sentence);
  const std::shared_ptr<dealii::Patterns::PatternBase> copy = pattern.clone();
  prm.add_action(entry, [&value, copy](const std::string& text) {
    value = dealii::Patterns::Tools::Convert<Value>::to_value(text, *copy);
  });
}

const Quantity& temperature()
{
  static const Quantity kelvin("K", 1., 1e4);
  return kelvin;
}

/// A number of the unit @p from (in SI units) as one of the unit @p to.
double converted(const double number, const Unit& from, const Unit& to)
{
  return from.factor == to.factor && from.zero == to.zero
             ? number
             : (number * from.factor + from.zero - to.zero) / to.factor;
}

} // namespace

Quantity::Quantity(std::string unit, const double smallest, const double largest)
    : unit(std::move(unit)), smallest(smallest), largest(largest)
{
}

Quantity Quantity::of_difference() const
{
  Quantity difference = *this;
  difference.is_difference = true;
  return difference;
}

Quantity Quantity::at_temperatures() const
{
  Quantity value = *this;
  value.may_be_in_table = true;
  return value;
}

bool Quantity::match(const std::string& text) const
{
  if (const std::size_t colon = text.find(':'); may_be_in_table && colon != std::string::npos)
    return temperature().match(text.substr(0, colon)) &&
           Quantity(unit, smallest, largest).match(text.substr(colon + 1));
  try {
    return dealii::Utilities::trim(text).find_last_not_of("+-.0123456789eE") == std::string::npos &&
           std::isfinite(value(text));
  } catch (const InputError&) {
    return false;
  }
}

std::string Quantity::description(const OutputStyle style) const
{
  if (style != Machine)
    return "a quantity in " + unit;
  std::ostringstream text;
  text << std::setprecision(17) << "[Quantity " << unit << ";" << smallest << ";" << largest << ";"
       << is_difference << ";" << may_be_in_table << "]";
  return text.str();
}

std::unique_ptr<dealii::Patterns::PatternBase> Quantity::clone() const
{
  return std::make_unique<Quantity>(*this);
}

double Quantity::value(const std::string& written) const
{
  const std::string text = dealii::Utilities::trim(written);
  const bool is_temperature = unit == "K" && !is_difference;
  const std::string typical = is_temperature                   ? "293"
                              : smallest > 0. && smallest < 1. ? "0.5"
                                                               : "20";
  const std::string example = typical + (unit == "1" ? "" : " or " + typical + " " + unit) +
                              (is_temperature ? " or 20 degC" : "");
  const NumberWithUnit given(text, example);
  double number = given.number;
  if (!given.unit.empty()) {
    const Unit wanted = *Unit::parse(unit);
    const std::optional<Unit> found = Unit::parse(given.unit);
    if (!found)
      throw InputError("'" + given.unit + "' in '" + text + "' is not a unit; write it as " +
                       example + "; known units: " + known_units());
    if (found->dimension != wanted.dimension)
      throw InputError("'" + text + "' is " + name_of_dimension(found->dimension) +
                       " but must be " + name_of_dimension(wanted.dimension) + "; write it as " +
                       example);
    if (is_difference && found->zero != 0.)
      throw InputError("'" + text + "' must be a temperature difference; write it in K");
    number = converted(number, *found, wanted);
  }
  if (number < smallest || number > largest)
    throw InputError(
        "'" + text + "' must be " +
        (number < smallest ? "at least " + text_of(smallest) : "at most " + text_of(largest)) +
        (unit == "1" ? "" : " " + unit));
  return number;
}

std::unique_ptr<Quantity> Quantity::within(const std::string& description)
{
  std::smatch parts;
  static const std::regex form("\\[Quantity ([^;]*);([^;]*);([^;]*);([01]);([01])\\]");
  if (!std::regex_search(description, parts, form))
    return nullptr;
  auto quantity = std::make_unique<Quantity>(parts[1], std::strtod(parts[2].str().c_str(), nullptr),
                                             std::strtod(parts[3].str().c_str(), nullptr));
  quantity->is_difference = parts[4] == "1";
  quantity->may_be_in_table = parts[5] == "1";
  return quantity;
}

std::string Quantity::plain(const std::string& text, const std::string& description)
{
  const std::unique_ptr<Quantity> quantity = within(description);
  if (!quantity)
    return text;
  const auto number = [](const Quantity& wanted, const std::string& given) {
    const double value = wanted.value(given);
    // What has no unit stays as it was written.
    return wanted.match(given) ? dealii::Utilities::trim(given) : text_of(value);
  };
  if (description.rfind("[Quantity", 0) == 0)
    return number(*quantity, text);
  std::string result;
  const bool is_map = description.rfind("[Map", 0) == 0;
  for (const std::string& part : dealii::Utilities::split_string_list(text)) {
    const std::size_t colon =
        is_map || quantity->may_be_in_table ? part.find(':') : std::string::npos;
    const bool has_colon = colon != std::string::npos;
    if (is_map && !has_colon)
      throw InputError("'" + part + "' has no value; write `name: value, name: value`");
    const std::string before = has_colon ? dealii::Utilities::trim(part.substr(0, colon)) : "";
    result += result.empty() ? "" : ", ";
    result += !has_colon ? "" : (is_map ? before : number(temperature(), before)) + ": ";
    result += number(*quantity, has_colon ? part.substr(colon + 1) : part);
  }
  return result;
}

void add_quantity(dealii::ParameterHandler& prm, const std::string& entry, double& value,
                  const std::string& sentence, const Quantity& quantity)
{
  declare(prm, entry, value, sentence + quantity.unit_sentence(), quantity);
}

void add_quantity(dealii::ParameterHandler& prm, const std::string& entry,
                  std::vector<double>& values, const std::string& sentence,
                  const Quantity& quantity, const unsigned int least, const unsigned int most)
{
  declare(prm, entry, values, sentence + quantity.unit_sentence(),
          dealii::Patterns::List(quantity, least, most));
}

void add_table_quantity(dealii::ParameterHandler& prm, const std::string& entry,
                        const std::vector<double>& coefficients, const std::string& sentence,
                        const Quantity& quantity, const ReadTable& read)
{
  constexpr unsigned int most = 100;
  prm.declare_entry(
      entry, text_of(coefficients),
      dealii::Patterns::List(quantity.at_temperatures(), coefficients.empty() ? 0 : 1, most),
      sentence + quantity.unit_sentence());
  prm.add_action(entry, [read](const std::string& text) {
    std::vector<double> temperatures, values;
    for (const std::string& row : dealii::Utilities::split_string_list(text)) {
      const std::size_t colon = row.find(':');
      if (colon != std::string::npos)
        temperatures.push_back(std::stod(row.substr(0, colon)));
      values.push_back(std::stod(colon == std::string::npos ? row : row.substr(colon + 1)));
    }
    if (!temperatures.empty() && temperatures.size() < values.size())
      throw InputError("'" + text +
                       "' has temperatures for some values only; write a table `273: value, 293: "
                       "value`, or coefficients");
    read(temperatures, values);
  });
}

void add_quantity(dealii::ParameterHandler& prm, const std::string& entry,
                  std::map<std::string, double>& values, const std::string& sentence,
                  const Quantity& quantity)
{
  declare(prm, entry, values, sentence + quantity.unit_sentence(),
          dealii::Patterns::Map(dealii::Patterns::Anything(), quantity, 0, 100));
}

} // namespace thelma
