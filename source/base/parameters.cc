#include <thelma/base/complaints.h>
#include <thelma/base/declared_entries.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>

#include <deal.II/base/utilities.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace thelma
{
namespace
{

std::string slashed(const std::vector<std::string>& path)
{
  std::string name;
  for (const std::string& section : path)
    name += (name.empty() ? "" : "/") + section;
  return name;
}

/// A pattern's description in words.
std::string in_words(const std::string& pattern)
{
  std::smatch found;
  if (std::regex_search(pattern, found, std::regex("^\\[Selection (.*) \\]$")))
    return "one of " + std::regex_replace(found[1].str(), std::regex("\\|"), ", ");
  if (std::regex_search(
          pattern, found,
          std::regex("^\\[(Integer|Double)(?: (?:range )?(\\S+)\\.\\.\\.(\\S+) .*)?\\]$"))) {
    const bool has_end = found[3].length() > 0 && found[3].length() < 8 && found[3] != "MAX_DOUBLE";
    return std::string(found[1] == "Integer" ? "an integer" : "a number") +
           (found[2].length() > 0 && found[2] != "-MAX_DOUBLE" ? " from " + found[2].str() : "") +
           (has_end ? " to " + found[3].str() : "");
  }
  return pattern == "[Bool]" ? "true or false" : pattern;
}

/// `'Tolerence'; did you mean ...` with the sections where an entry of this name belongs.
std::string unknown_entry(const DeclaredEntries& declared, const Statement& statement)
{
  const std::vector<std::string> elsewhere = declared.sections_with(statement.entry);
  const std::vector<std::string> here = declared.entries(statement.sections);
  std::string sentence = "unknown entry '" + statement.entry + "'";
  if (closest(statement.entry, here).empty() && !elsewhere.empty())
    sentence += "; it belongs to the section " + comma_separated(elsewhere) +
                "; known here: " + comma_separated(here);
  else
    sentence += known_ones(statement.entry, here);
  return sentence;
}

/// The first section of @p path that is not declared, if any, as a sentence.
std::string unknown_section(const DeclaredEntries& declared, const std::vector<std::string>& path)
{
  std::vector<std::string> parent;
  for (const std::string& section : path) {
    const std::vector<std::string> known = declared.sections(parent);
    parent.push_back(section);
    if (!declared.has_section(parent))
      return "unknown subsection '" + section + "'" + known_ones(section, known);
  }
  return "";
}

/// Throws InputError, with a sentence without place, if the entry cannot have this value.
void set(dealii::ParameterHandler& prm, const DeclaredEntries& declared, const Statement& statement)
{
  const std::string pattern = declared.pattern(statement.sections, statement.entry);
  const Section section(prm, statement.sections);
  try {
    prm.set(statement.entry, Quantity::plain(statement.value, pattern));
  } catch (const dealii::ExceptionBase&) {
    throw InputError("the value is '" + statement.value + "' but must be " + in_words(pattern));
  }
}

} // namespace

Override Override::parse(const std::string& text)
{
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("command line: '" + text + "' is not of the form Section/Entry=value");
  Override result;
  result.value =
      dealii::Utilities::trim(std::regex_replace(text.substr(equals + 1), std::regex("\\s+"), " "));
  if (result.value.find('#') != std::string::npos)
    throw InputError("command line: '" + text +
                     "' has a '#', which begins a comment in parameter "
                     "files; write it without");
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
  std::error_code ignored;
  if (!stream || std::filesystem::is_directory(path) ||
      !(content << stream.rdbuf() || std::filesystem::is_empty(path, ignored)))
    throw InputError(path + ": cannot read this parameter file; give the path of an existing .prm");
  statements = Statements(content.str());
  for (const Override& change : overrides)
    statements.entries.push_back({0, change.sections, change.entry, change.value});
}

ParameterFile ParameterFile::from_text(const std::string& text, const std::string& name)
{
  ParameterFile file;
  file.path = name;
  file.statements = Statements(text);
  return file;
}

void ParameterFile::peek(const std::function<void(dealii::ParameterHandler&)>& declare) const
{
  dealii::ParameterHandler prm;
  declare(prm);
  const DeclaredEntries declared(prm);
  Complaints unheard; // whatever is wrong is reported by read(), which knows every entry
  for (const Statement& statement : statements.entries)
    if (declared.has_entry(statement.sections, statement.entry))
      unheard.allow([&]() { set(prm, declared, statement); });
}

void ParameterFile::read(dealii::ParameterHandler& prm) const
{
  const DeclaredEntries declared(prm);
  std::multimap<unsigned int, std::string> found; // by line; the command line comes last
  const auto complain = [&](const unsigned int line, const std::string& sentence) {
    found.emplace(line == 0 ? std::numeric_limits<unsigned int>::max() : line, sentence);
  };
  for (const Statements::Problem& problem : statements.problems)
    complain(problem.line, place(problem.line, {}) + ": " + problem.sentence);
  for (const OpenedSection& section : statements.sections) {
    const std::vector<std::string> parent(section.path.begin(), section.path.end() - 1);
    if (declared.has_section(parent) && !declared.has_section(section.path))
      complain(section.line,
               place(section.line, parent) + ": " + unknown_section(declared, section.path));
  }
  for (const Statement& statement : statements.entries) {
    const std::string where = place(statement.line, statement.sections);
    if (const std::string unknown = unknown_section(declared, statement.sections);
        !unknown.empty()) {
      if (statement.line == 0)
        complain(0, where + ": " + unknown);
    } else if (!declared.has_entry(statement.sections, statement.entry))
      complain(statement.line, where + ": " + unknown_entry(declared, statement));
    else
      try {
        set(prm, declared, statement);
      } catch (const InputError& error) {
        complain(statement.line, where + ", entry '" + statement.entry + "': " + error.what());
      }
  }
  Complaints complaints;
  for (const auto& entry : found)
    complaints.add(entry.second);
  complaints.raise();
}

std::string ParameterFile::place(const unsigned int line,
                                 const std::vector<std::string>& sections) const
{
  return (line == 0 ? "command line" : path + ":" + std::to_string(line)) +
         (sections.empty() ? "" : ", section " + slashed(sections));
}

std::string ParameterFile::located(const std::string& sentence) const
{
  std::smatch parts;
  if (sentence.rfind("section ", 0) != 0)
    return sentence;
  const std::string head = sentence.substr(0, sentence.find(": "));
  if (!std::regex_search(head, parts, std::regex("^section ([^,]+)(?:, entry '([^']*)')?")))
    return path + ", " + sentence;
  std::string where = path;
  for (const OpenedSection& section : statements.sections)
    if (slashed(section.path) == parts[1])
      where = path + ":" + std::to_string(section.line);
  for (const Statement& statement : statements.entries)
    if (slashed(statement.sections) == parts[1] && statement.entry == parts[2])
      where = statement.line == 0 ? "command line" : path + ":" + std::to_string(statement.line);
  return where + ", " + sentence;
}

std::string located(const std::string& file, const std::string& folder)
{
  const std::filesystem::path there = std::filesystem::path(folder) / file;
  std::error_code too_long;
  return !std::filesystem::exists(file, too_long) && std::filesystem::exists(there, too_long)
             ? there.string()
             : file;
}

Section::Section(dealii::ParameterHandler& prm, const std::vector<std::string>& path)
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
