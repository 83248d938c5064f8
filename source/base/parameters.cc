#include <thelma/base/declared_entries.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/parameters.h>
#include <thelma/base/pattern_words.h>
#include <thelma/base/quantity.h>
#include <thelma/base/wording.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
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

/// A map keeps one value of each name, and no one could tell which.
void require_distinct_names(const std::string& map)
{
  std::set<std::string> names;
  for (const std::string& part : dealii::Utilities::split_string_list(map)) {
    const std::string name = dealii::Utilities::trim(part.substr(0, part.find(':')));
    if (!names.insert(name).second)
      throw InputError("'" + name + "' is given twice; write every name once");
  }
}

/// `'Tolerence'; did you mean ...` with the sections where an entry of this name belongs.
std::string unknown_entry(const DeclaredEntries& declared, const Statement& statement)
{
  const std::vector<std::string> elsewhere = declared.sections_with(statement.entry);
  const std::vector<std::string> here = declared.entries(statement.sections);
  std::string sentence = "unknown entry '" + statement.entry + "'";
  if (const std::string remedy = other_wording(statement.entry);
      elsewhere.empty() && !remedy.empty())
    return sentence + "; " + remedy;
  if (closest(statement.entry, here).empty() && !elsewhere.empty())
    sentence += "; it belongs to the section " + comma_separated(elsewhere) +
                "; known here: " + comma_separated(here);
  else
    sentence += did_you_mean(statement.entry, here);
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
      return "unknown subsection '" + section + "'" + did_you_mean(section, known);
  }
  return "";
}

/// Throws InputError, with a sentence without place, if the entry cannot have this value.
void set(dealii::ParameterHandler& prm, const DeclaredEntries& declared, const Statement& statement)
{
  const std::string pattern = declared.pattern(statement.sections, statement.entry);
  const Section section(prm, statement.sections);
  if (pattern.rfind("[Map", 0) == 0)
    require_distinct_names(statement.value);
  try {
    prm.set(statement.entry, Quantity::plain(statement.value, pattern));
  } catch (const dealii::ExceptionBase&) {
    const std::string guess = closest(statement.value, choices(pattern));
    throw InputError("the value is '" + statement.value + "' but must be " + in_words(pattern) +
                     (guess.empty() ? "" : "; did you mean '" + guess + "'?"));
  }
}

} // namespace

Override Override::parse(const std::string& text)
{
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("command line: '" + text + "' is not of the form Section/Entry=value");
  Override result;
  result.value = unquoted(dealii::Utilities::trim(
      std::regex_replace(text.substr(equals + 1), std::regex("\\s+"), " ")));
  if (result.value.find('#') != std::string::npos)
    throw InputError("command line: '" + text +
                     "' has a '#', which begins a comment in parameter "
                     "files; write the value without it");
  result.sections = dealii::Utilities::split_string_list(text.substr(0, equals), '/');
  result.entry = result.sections.back();
  result.sections.pop_back();
  return result;
}

std::string Override::path() const
{
  return slashed(sections) + (sections.empty() ? "" : "/") + entry;
}

ParameterFile::ParameterFile(std::string file, const std::vector<Override>& overrides)
    : path(std::move(file)), shown(path)
{
  std::ifstream stream(path);
  std::stringstream content;
  std::error_code ignored;
  const std::string extension = std::filesystem::path(path).extension().string();
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(path + ": this is a folder; give the path of a .prm in it");
  if (extension == ".geo" || extension == ".msh")
    throw InputError(path +
                     ": this is a geometry, not a parameter file; name it in a .prm, in the "
                     "section Mesh as `set File = " +
                     std::filesystem::path(path).filename().string() + "`, and run that");
  if (!stream || !(content << stream.rdbuf() || std::filesystem::is_empty(path, ignored)))
    throw InputError(path + ": cannot read this parameter file; give the path of an existing .prm");
  const std::string start = content.str().substr(0, 2);
  if (start == "\xFF\xFE" || start == "\xFE\xFF")
    throw InputError(path + ": this file is UTF-16; save it as UTF-8");
  statements = Statements(content.str());
  for (const Override& change : overrides)
    statements.entries.push_back({0, change.sections, change.entry, change.value});
}

ParameterFile ParameterFile::from_text(const std::string& text, const std::string& name,
                                       const std::string& shown)
{
  ParameterFile file;
  file.path = name;
  file.shown = shown.empty() ? name : shown;
  file.statements = Statements(text);
  return file;
}

ParameterFile ParameterFile::only(const std::vector<std::string>& names) const
{
  const auto keep = [&](auto& list, const auto path) {
    const auto is_other = [&](const auto& one) {
      return (one.*path).empty() ||
             std::find(names.begin(), names.end(), (one.*path).front()) == names.end();
    };
    list.erase(std::remove_if(list.begin(), list.end(), is_other), list.end());
  };
  ParameterFile part = *this;
  keep(part.statements.entries, &Statement::sections);
  keep(part.statements.sections, &OpenedSection::path);
  return part;
}

void ParameterFile::peek(const std::function<void(dealii::ParameterHandler&)>& declare) const
{
  dealii::ParameterHandler prm;
  declare(prm);
  const DeclaredEntries declared(prm);
  InputErrors unheard; // whatever is wrong is reported by read(), which knows every entry
  for (const Statement& statement : statements.entries)
    if (declared.has_entry(statement.sections, statement.entry))
      unheard.collect([&]() { set(prm, declared, statement); });
}

bool ParameterFile::has_section(const std::vector<std::string>& path) const
{
  return std::any_of(statements.entries.begin(), statements.entries.end(),
                     [&](const Statement& statement) { return statement.sections == path; });
}

std::vector<std::string> ParameterFile::subsections(const std::vector<std::string>& path) const
{
  std::vector<std::string> names;
  for (const Statement& statement : statements.entries) {
    const std::vector<std::string>& sections = statement.sections;
    if (sections.size() > path.size() && std::equal(path.begin(), path.end(), sections.begin()) &&
        std::find(names.begin(), names.end(), sections[path.size()]) == names.end())
      names.push_back(sections[path.size()]);
  }
  return names;
}

std::vector<std::string> ParameterFile::entries(const std::vector<std::string>& path) const
{
  std::vector<std::string> names;
  for (const Statement& statement : statements.entries)
    if (statement.sections == path)
      names.push_back(statement.entry);
  return names;
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
  std::map<std::pair<std::vector<std::string>, std::string>, unsigned int> first_set;
  for (const Statement& statement : statements.entries) {
    const std::string where = place(statement.line, statement.sections);
    const auto [first, is_new] =
        first_set.emplace(std::pair(statement.sections, statement.entry), statement.line);
    if (statement.line > 0 && !is_new)
      complain(statement.line, where + ", entry '" + statement.entry +
                                   "': it is already set on line " + std::to_string(first->second) +
                                   "; remove one of the two");
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
  InputErrors errors;
  for (const auto& entry : found)
    errors.add(entry.second);
  errors.raise();
}

std::string ParameterFile::place(const unsigned int line,
                                 const std::vector<std::string>& sections) const
{
  return (line == 0 ? "command line" : shown + ":" + std::to_string(line)) +
         (sections.empty() ? "" : ", section " + slashed(sections));
}

std::string ParameterFile::located(const std::string& sentence) const
{
  std::smatch parts;
  if (sentence.rfind("section ", 0) != 0)
    return sentence;
  const std::string head = sentence.substr(0, sentence.find(": "));
  if (!std::regex_search(head, parts, std::regex("^section ([^,]+)(?:, entry '([^']*)')?")))
    return shown + ", " + sentence;
  std::string where = shown;
  for (const OpenedSection& section : statements.sections)
    if (slashed(section.path) == parts[1])
      where = shown + ":" + std::to_string(section.line);
  for (const Statement& statement : statements.entries)
    if (slashed(statement.sections) == parts[1] && statement.entry == parts[2])
      where = statement.line == 0 ? "command line" : shown + ":" + std::to_string(statement.line);
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

void check_values(dealii::ParameterHandler& prm, const std::string& entry,
                  const std::function<void(const std::string&)>& check)
{
  using Map = std::map<std::string, std::string>;
  prm.add_action(entry, [check](const std::string& text) {
    for (const auto& value : dealii::Patterns::Tools::Convert<Map>::to_value(text))
      check(value.second);
  });
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
