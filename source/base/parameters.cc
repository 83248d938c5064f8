#include <thelma/base/error.h>
#include <thelma/base/parameters.h>

#include <deal.II/base/utilities.h>

#include <boost/property_tree/json_parser.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace thelma
{
namespace
{

/// The sections open at line @p number (from 1) of a parameter file.
std::vector<std::string> sections_at(const std::string& text, const unsigned int number)
{
  std::vector<std::string> path;
  std::istringstream lines(text);
  std::string line;
  for (unsigned int i = 1; i < number && std::getline(lines, line); ++i) {
    line = dealii::Utilities::trim(line);
    if (line.rfind("subsection ", 0) == 0)
      path.push_back(dealii::Utilities::trim(line.substr(11)));
    else if (line == "end" && !path.empty())
      path.pop_back();
  }
  return path;
}

/// Entries (or subsections) that @p prm declares in the section @p path.
std::vector<std::string> known_names(const dealii::ParameterHandler& prm,
                                     const std::vector<std::string>& path, const bool sections)
{
  std::stringstream json;
  prm.print_parameters(json, dealii::ParameterHandler::JSON);
  boost::property_tree::ptree tree;
  boost::property_tree::read_json(json, tree);
  for (const std::string& section : path) {
    const auto child = tree.find(section);
    if (child == tree.not_found())
      return {};
    tree = boost::property_tree::ptree(child->second);
  }
  std::vector<std::string> names;
  for (const auto& [name, child] : tree)
    if ((child.find("value") == child.not_found()) == sections)
      names.push_back(name);
  return names;
}

std::string section_name(const std::vector<std::string>& path)
{
  std::string name;
  for (const std::string& section : path)
    name += (name.empty() ? "" : "/") + section;
  return name.empty() ? "the top level" : "section " + name;
}

/// First group of @p pattern in @p text, or an empty string.
std::string match(const std::string& text, const std::string& pattern)
{
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern)) ? found[1].str() : "";
}

/// A pattern's description without deal.II's brackets.
std::string in_words(const std::string& pattern)
{
  if (const std::string choices = match(pattern, "^\\[Selection (.*) \\]$"); !choices.empty())
    return "one of " + std::regex_replace(choices, std::regex("\\|"), ", ");
  return pattern;
}

} // namespace

Override Override::parse(const std::string& text)
{
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("command line: '" + text + "' is not of the form Section/Entry=value");
  Override result;
  result.value = dealii::Utilities::trim(text.substr(equals + 1));
  result.sections = dealii::Utilities::split_string_list(text.substr(0, equals), '/');
  result.entry = result.sections.back();
  result.sections.pop_back();
  return result;
}

std::string Override::path() const
{
  std::string result;
  for (const std::string& section : sections)
    result += section + "/";
  return result + entry;
}

ParameterFile::ParameterFile(std::string file, const std::vector<Override>& overrides)
    : path(std::move(file))
{
  std::ifstream stream(path);
  std::stringstream content;
  if (!stream || !(content << stream.rdbuf()))
    throw InputError(path + ": cannot read this parameter file; give the path of an existing .prm");
  text = content.str() + "\n";
  n_file_lines = std::count(text.begin(), text.end(), '\n');
  for (const Override& change : overrides) {
    for (const std::string& section : change.sections)
      text += "subsection " + section + "\n";
    text += "set " + change.entry + " = " + change.value + "\n";
    for (std::size_t i = 0; i < change.sections.size(); ++i)
      text += "end\n";
  }
}

ParameterFile ParameterFile::from_text(const std::string& text)
{
  ParameterFile file;
  file.path = "parameters";
  file.text = text;
  return file;
}

void ParameterFile::peek(const std::function<void(dealii::ParameterHandler&)>& declare) const
{
  dealii::ParameterHandler prm;
  declare(prm);
  try {
    prm.parse_input_from_string(text, "", true);
  } catch (const dealii::ExceptionBase&) {
    // Whatever is wrong is reported by read(), which knows every entry.
  }
}

void ParameterFile::read(dealii::ParameterHandler& prm) const
{
  try {
    prm.parse_input_from_string(text, "", false);
  } catch (const dealii::ExceptionBase& exception) {
    std::ostringstream stream;
    exception.print_info(stream);
    const std::string info = std::regex_replace(stream.str(), std::regex("\\s+"), " ");

    const std::string number = match(info, "Line <(\\d+)>");
    const unsigned int line = number.empty() ? 0 : std::stoul(number);
    const std::vector<std::string> section = sections_at(text, line);
    const std::string place = line == 0
                                  ? path
                                  : (line > n_file_lines ? "command line" : path + ":" + number) +
                                        ", " + section_name(section);

    if (const std::string entry = match(info, "No entry with name <(.*)> was"); !entry.empty())
      throw InputError(place + ": unknown entry '" + entry +
                       "'; known entries: " + comma_separated(known_names(prm, section, false)));
    if (const std::string name = match(info, "no such subsection to be entered: (.*?) ?$");
        !name.empty())
      throw InputError(place + ": unknown subsection '" + name +
                       "'; known subsections: " + comma_separated(known_names(prm, section, true)));
    if (const std::string entry = match(info, "entry named (.*) does not match"); !entry.empty())
      throw InputError(place + ": entry '" + entry + "' has the value '" +
                       match(info, "entry value (.*) for the entry") + "' but must be " +
                       in_words(match(info, "given pattern: (.*?) ?$")));
    throw InputError(place + ": " +
                     std::regex_replace(info, std::regex("^ | $|<input string>?"), ""));
  }
}

std::string located(const std::string& file, const std::string& folder)
{
  const std::filesystem::path there = std::filesystem::path(folder) / file;
  return !std::filesystem::exists(file) && std::filesystem::exists(there) ? there.string() : file;
}

Section::Section(dealii::ParameterHandler& prm, std::vector<std::string> path)
    : prm(prm), depth(path.size())
{
  for (const std::string& section : path)
    prm.enter_subsection(section);
}

Section::~Section()
{
  for (std::size_t i = 0; i < depth; ++i)
    prm.leave_subsection();
}

} // namespace thelma
