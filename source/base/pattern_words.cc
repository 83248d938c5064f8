#include <thelma/base/error.h>
#include <thelma/base/pattern_words.h>

#include <deal.II/base/utilities.h>

#include <regex>

namespace thelma
{
namespace
{

std::string each(const std::string& what, const std::string& pattern)
{
  return pattern == "[Anything]" ? "" : ", each " + what + " " + in_words(pattern);
}

} // namespace

std::vector<std::string> choices(const std::string& pattern)
{
  std::smatch found;
  if (!std::regex_search(pattern, found, std::regex("^\\[Selection (.*) \\]$")))
    return {};
  return dealii::Utilities::split_string_list(found[1].str(), '|');
}

std::string in_words(const std::string& pattern)
{
  std::smatch found;
  if (const std::vector<std::string> known = choices(pattern); !known.empty())
    return "one of " + comma_separated(known);
  const std::string length = " of length \\d+\\.\\.\\.(\\d+) ";
  if (std::regex_search(pattern, found, std::regex("^\\[Map of <(.*)>:<(.*)>" + length)))
    return "`name: value`" +
           std::string(found[3] == "1" ? "" : ", or several separated by commas") +
           each("name", found[1]) + each("value", found[2]);
  if (std::regex_search(pattern, found, std::regex("^\\[List of <(.*)>" + length)))
    return "a list of at most " + found[2].str() + each("value", found[1]);
  if (std::regex_search(
          pattern, found,
          std::regex("^\\[(Integer|Double)(?: (?:range )?(\\S+)\\.\\.\\.(\\S+) .*)?\\]$"))) {
    const bool has_end = found[3].length() > 0 && found[3].length() < 8 && found[3] != "MAX_DOUBLE";
    return std::string(found[1] == "Integer" ? "an integer" : "a number") +
           (found[2].length() > 0 && found[2] != "-MAX_DOUBLE" ? " from " + found[2].str() : "") +
           (has_end ? " to " + found[3].str() : "");
  }
  if (std::regex_search(pattern, found, std::regex("^\\[Quantity ([^;]*);")))
    return "a number" + (found[1] == "1" ? "" : " in " + found[1].str());
  return pattern == "[Bool]" ? "true or false" : pattern;
}

} // namespace thelma
