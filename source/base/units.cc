#include <thelma/base/error.h>
#include <thelma/base/units.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <map>
#include <regex>
#include <utility>
#include <vector>

namespace thelma
{
namespace
{

using Dimension = std::array<int, 5>; // m, kg, s, A, K

const std::map<std::string, Unit>& symbols()
{
  static const std::map<std::string, Unit> list{
      {"m", {{{1, 0, 0, 0, 0}}}},         {"g", {{{0, 1, 0, 0, 0}}, 1e-3}},
      {"s", {{{0, 0, 1, 0, 0}}}},         {"A", {{{0, 0, 0, 1, 0}}}},
      {"K", {{{0, 0, 0, 0, 1}}}},         {"N", {{{1, 1, -2, 0, 0}}}},
      {"Pa", {{{-1, 1, -2, 0, 0}}}},      {"J", {{{2, 1, -2, 0, 0}}}},
      {"W", {{{2, 1, -3, 0, 0}}}},        {"V", {{{2, 1, -3, -1, 0}}}},
      {"C", {{{0, 0, 1, 1, 0}}}},         {"F", {{{-2, -1, 4, 2, 0}}}},
      {"min", {{{0, 0, 1, 0, 0}}, 60.}},  {"h", {{{0, 0, 1, 0, 0}}, 3600.}},
      {"bar", {{{-1, 1, -2, 0, 0}}, 1e5}}};
  return list;
}

std::optional<Unit> symbol(const std::string& text)
{
  const auto found = symbols().find(text);
  if (found != symbols().end())
    return found->second;
  static const std::map<char, double> prefixes{{'f', 1e-15}, {'p', 1e-12}, {'n', 1e-9}, {'u', 1e-6},
                                               {'m', 1e-3},  {'c', 1e-2},  {'d', 1e-1}, {'k', 1e3},
                                               {'M', 1e6},   {'G', 1e9}};
  const auto prefix = text.empty() ? prefixes.end() : prefixes.find(text[0]);
  const auto base = prefix == prefixes.end() ? symbols().end() : symbols().find(text.substr(1));
  if (base == symbols().end() || base->first == "min" || base->first == "h")
    return std::nullopt;
  Unit unit = base->second;
  unit.factor *= prefix->second;
  return unit;
}

/// product := power {blank or * or / power}; power := (symbol or 1 or '(' product ')') ['^' n]
class UnitReader
{
public:
  explicit UnitReader(const std::string& text) : text(text) {}

  std::optional<Unit> read()
  {
    Unit unit;
    return product(unit, 0) && at == text.size() ? std::optional<Unit>(unit) : std::nullopt;
  }

private:
  bool product(Unit& unit, const unsigned int depth)
  {
    int sign = 1;
    while (depth < 10) {
      Unit factor;
      int exponent = 1;
      if (!power(factor, exponent, depth))
        return false;
      for (std::size_t d = 0; d < unit.dimension.size(); ++d)
        unit.dimension[d] += sign * exponent * factor.dimension[d];
      unit.factor *= std::pow(factor.factor, sign * exponent);
      if (at == text.size() || text[at] == ')')
        return true;
      sign = text[at] == '/' ? -1 : 1;
      if (text[at] == '/' || text[at] == '*' || text[at] == ' ')
        ++at;
    }
    return false;
  }

  bool power(Unit& unit, int& exponent, const unsigned int depth)
  {
    if (at == text.size())
      return false;
    if (text[at] == '(') {
      ++at;
      if (!product(unit, depth + 1) || at == text.size())
        return false;
      ++at;
    } else if (text[at] == '1')
      ++at;
    else {
      const std::size_t begin = at;
      while (at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])))
        ++at;
      const std::optional<Unit> found = symbol(text.substr(begin, at - begin));
      if (!found)
        return false;
      unit = *found;
    }
    return at == text.size() || text[at] != '^' || read_exponent(exponent);
  }

  bool read_exponent(int& exponent)
  {
    ++at;
    const int sign = at < text.size() && text[at] == '-' ? -1 : 1;
    at += sign < 0 ? 1 : 0;
    if (at == text.size() || text[at] < '1' || text[at] > '9')
      return false;
    exponent = sign * (text[at] - '0');
    ++at;
    return true;
  }

  const std::string text;
  std::size_t at = 0;
};

/// Without blanks that mean nothing; "µ" and "°" as ASCII.
std::string simplified(std::string text)
{
  // Compiled once: a scene has a hundred entries with units.
  static const std::vector<std::pair<std::regex, std::string>> replacements{
      {std::regex("\u00b5|\u03bc"), "u"},
      {std::regex("\u00b0"), "deg"},
      {std::regex("(?:\\s|\u00b7)+"), " "},
      {std::regex(" ?([*/^()]) ?"), "$1"}};
  for (const auto& [form, replacement] : replacements)
    text = std::regex_replace(text, form, replacement);
  return dealii::Utilities::trim(text);
}

} // namespace

std::optional<Unit> Unit::parse(const std::string& text)
{
  const std::string unit = simplified(text);
  if (unit == "degC")
    return Unit{{{0, 0, 0, 0, 1}}, 1., 273.15};
  return unit.empty() ? Unit() : UnitReader(unit).read();
}

std::string known_units()
{
  std::vector<std::string> known{"degC"};
  for (const auto& entry : symbols())
    known.push_back(entry.first);
  return comma_separated(known) + ", with prefixes from f to G, and products such as W/(m K)";
}

std::string name_of_dimension(const Dimension& dimension)
{
  static const std::vector<std::pair<std::string, std::string>> names{
      {"1", "a plain number"},
      {"m", "a length"},
      {"s", "a time"},
      {"K", "a temperature"},
      {"V", "a voltage"},
      {"C", "a charge"},
      {"A", "a current"},
      {"C/m^2", "a charge per area"},
      {"g", "a mass"},
      {"N", "a force"},
      {"Pa", "a pressure"},
      {"J", "an energy"},
      {"W", "a power"},
      {"F", "a capacitance"},
      {"F/m", "a permittivity"},
      {"V/m", "an electric field"},
      {"1/K", "a thermal expansion coefficient"},
      {"J/(m^3 K)", "a heat capacity per volume"},
      {"W/(m K)", "a conductivity"},
      {"W/m^2", "a heat flux"},
      {"W/(m^2 K)", "a heat transfer coefficient"},
      {"W/m^3", "a heat source"}};
  for (const auto& [unit, name] : names)
    if (Unit::parse(unit)->dimension == dimension)
      return name;
  std::string text = "a quantity in";
  const std::array<std::string, 5> base{{"m", "kg", "s", "A", "K"}};
  for (std::size_t d = 0; d < base.size(); ++d)
    if (dimension[d] != 0)
      text += " " + base[d] + (dimension[d] == 1 ? "" : "^" + std::to_string(dimension[d]));
  return text;
}

NumberWithUnit::NumberWithUnit(const std::string& text, const std::string& example)
{
  std::smatch parts;
  static const std::regex form(
      "^\\s*([-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?)\\s*(\\D.*)?$");
  // std::regex descends once per character.
  const bool reads = text.size() < 200 && std::regex_match(text, parts, form);
  number = reads ? std::strtod(parts[1].str().c_str(), nullptr) : NAN;
  if (!std::isfinite(number))
    throw InputError("'" + text + "' is not a number; write it as " + example);
  unit = dealii::Utilities::trim(parts[2].str());
  if (!unit.empty() && unit[0] == ',')
    throw InputError("'" + text + "' has a comma; write a single number with a decimal point, as " +
                     example);
}

} // namespace thelma
