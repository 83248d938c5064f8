#include <thelma/application/excerpt.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

namespace thelma
{
namespace
{

std::string lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool has(const std::string& text, const std::string& word)
{
  return lower(text).find(lower(word)) != std::string::npos;
}

/// Lines with a heading, to which the first of them belongs.
struct Item {
  std::string heading, text;
};

std::vector<Item> items_of(const std::string& text)
{
  std::vector<Item> items;
  std::istringstream lines(text);
  std::string heading;
  bool begins = true, was_item = false;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    if (indent == 2 || begins || (indent == 0 && was_item))
      items.push_back({indent == 0 ? "" : heading, ""});
    if (line.empty())
      heading.clear();
    else if (indent == 0)
      heading = line + "\n";
    else if (indent == 2 && !items.back().heading.empty() && items.size() > 1 &&
             items[items.size() - 2].text == heading)
      items.erase(items.end() - 2); // a heading of items is no item
    items.back().text += line.empty() ? "" : line + "\n";
    begins = line.empty();
    was_item = indent >= 2;
  }
  return items;
}

} // namespace

std::string items_with(const std::string& text, const std::string& word)
{
  std::string found, heading;
  for (const Item& item : items_of(text)) {
    if (!has(item.heading + item.text, word))
      continue;
    if (item.heading != heading)
      found += item.heading;
    heading = item.heading;
    found += item.text;
  }
  return found;
}

std::string entries_with(const std::string& parameters, const std::string& word)
{
  std::istringstream lines(parameters);
  std::string found, remarks, path;
  std::size_t taken = 0; // depth of the section that is taken as a whole
  std::vector<std::string> sections;
  for (std::string line; std::getline(lines, line);) {
    const std::string content = dealii::Utilities::trim(line);
    const bool opens = content.rfind("subsection ", 0) == 0, closes = content == "end";
    if (opens) {
      sections.push_back(content.substr(11));
      remarks.clear();
      if (taken == 0 && has(sections.back(), word))
        taken = sections.size();
    }
    if (content.rfind('#', 0) == 0)
      remarks += line + "\n";
    else if (taken > 0)
      found += line + "\n";
    else if (content.rfind("set ", 0) == 0 && has(content.substr(4, content.find('=') - 4), word)) {
      std::string where;
      for (const std::string& section : sections)
        where += (where.empty() ? "" : "/") + section;
      found +=
          "# " + (where.empty() ? "outside of all sections" : where) + "\n" + remarks + line + "\n";
    }
    if (content.rfind('#', 0) == 0 && taken > 0)
      found += line + "\n";
    else if (content.rfind('#', 0) != 0)
      remarks.clear();
    if (closes && !sections.empty()) {
      if (taken == sections.size())
        taken = 0;
      sections.pop_back();
    }
  }
  return found;
}

} // namespace thelma
