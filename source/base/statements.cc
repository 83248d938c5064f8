#include <thelma/base/statements.h>
#include <thelma/base/wording.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace thelma
{
namespace
{

/// Without comment, tabs, and blanks that mean nothing.
std::string cleaned(const std::string& line)
{
  std::istringstream words(line.substr(0, line.find('#')));
  std::string result;
  for (std::string word; words >> word;)
    result += (result.empty() ? "" : " ") + word;
  return result;
}

/// For the case that someone takes another file for a parameter file.
std::string printable(std::string text)
{
  const auto is_odd = [](const unsigned char c) { return std::isprint(c) == 0; };
  std::replace_if(text.begin(), text.end(), is_odd, '?');
  return text;
}

/// What follows @p keyword, if the line begins with it.
bool begins_with(const std::string& line, const std::string& keyword, std::string& rest)
{
  const std::string first = line.substr(0, keyword.size());
  const bool ends = line.size() <= keyword.size() || line[keyword.size()] == ' ';
  std::string upper;
  for (const char c : keyword)
    upper += static_cast<char>(c - 'a' + 'A');
  if ((first != keyword && first != upper) || !ends)
    return false;
  rest = dealii::Utilities::trim(line.substr(keyword.size()));
  return true;
}

} // namespace

Statements::Statements(const std::string& text)
{
  constexpr char byte_order_mark[] = "\xEF\xBB\xBF"; // some editors begin UTF-8 with it
  std::istringstream stream(text.rfind(byte_order_mark, 0) == 0 ? text.substr(3) : text);
  std::string line, begun;
  unsigned int number = 0, first = 0;
  while (std::getline(stream, line)) {
    ++number;
    first = begun.empty() ? number : first;
    line = cleaned(line);
    if (!line.empty() && line.back() == '\\') {
      begun += line.substr(0, line.size() - 1) + " ";
      continue;
    }
    line = cleaned(begun + line);
    begun.clear();
    if (!line.empty())
      add(first, line);
  }
  if (!begun.empty())
    problems.push_back({first, "the last line ends in `\\`, so its continuation is missing; "
                               "remove the `\\` or complete the line"});
  for (const OpenedSection& section : open)
    problems.push_back({section.line, "the subsection '" + section.path.back() +
                                          "' is not closed; write `end` after its last entry"});
}

void Statements::add(const unsigned int number, const std::string& line)
{
  const std::vector<std::string> path =
      open.empty() ? std::vector<std::string>() : open.back().path;
  std::string rest;
  if (begins_with(line, "subsection", rest) && !rest.empty()) {
    open.push_back({number, path});
    open.back().path.push_back(rest);
    sections.push_back(open.back());
  } else if (begins_with(line, "end", rest) && rest.empty()) {
    if (open.empty())
      problems.push_back({number, "`end` without a subsection; remove it"});
    else
      open.pop_back();
  } else if (begins_with(line, "set", rest)) {
    const std::size_t equals = rest.find('=');
    const std::string entry = dealii::Utilities::trim(rest.substr(0, equals));
    if (equals == std::string::npos || entry.empty())
      problems.push_back({number, "'" + line + "' is not of the form `set Entry = value`"});
    else
      entries.push_back(
          {number, path, entry, unquoted(dealii::Utilities::trim(rest.substr(equals + 1)))});
  } else
    problems.push_back({number, "cannot read '" + printable(line.substr(0, 80)) +
                                    "'; write `subsection Name`, `set Entry = value` or `end`"});
}

} // namespace thelma
