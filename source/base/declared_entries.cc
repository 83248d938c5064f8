#include <thelma/base/declared_entries.h>

#include <boost/property_tree/xml_parser.hpp>

#include <sstream>

namespace thelma
{
namespace
{

using Tree = boost::property_tree::ptree;

bool is_entry(const Tree& node)
{
  return node.find("value") != node.not_found() && node.find("pattern") != node.not_found();
}

/// deal.II writes what is neither letter nor digit as _ and two hexadecimal digits.
std::string unmangled(const std::string& name)
{
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name[i] == '_' && i + 2 < name.size()) {
      result += static_cast<char>(std::stoi(name.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else
      result += name[i];
  return result;
}

/// @p section with the names that the parameter files use.
Tree named(const Tree& section)
{
  Tree result;
  for (const auto& [name, child] : section)
    result.push_back({unmangled(name), is_entry(child) ? child : named(child)});
  return result;
}

std::vector<std::string> names(const Tree* section, const bool of_entries)
{
  std::vector<std::string> result;
  if (section != nullptr)
    for (const auto& [name, child] : *section)
      if (is_entry(child) == of_entries)
        result.push_back(name);
  return result;
}

void find(const Tree& section, const std::string& entry, const std::string& path,
          std::vector<std::string>& found)
{
  for (const auto& [name, child] : section)
    if (is_entry(child)) {
      if (name == entry && !path.empty())
        found.push_back(path);
    } else
      find(child, entry, path.empty() ? name : path + "/" + name, found);
}

} // namespace

DeclaredEntries::DeclaredEntries(const dealii::ParameterHandler& prm)
{
  // Not as JSON, in which deal.II takes a dot in a name for a separator.
  std::stringstream xml;
  prm.print_parameters(xml, dealii::ParameterHandler::XML);
  Tree all;
  boost::property_tree::read_xml(xml, all);
  tree = named(all.get_child("ParameterHandler"));
}

const DeclaredEntries::Tree* DeclaredEntries::at(const std::vector<std::string>& path) const
{
  const Tree* node = &tree;
  for (const std::string& section : path) {
    const auto child = node->find(section);
    if (child == node->not_found() || is_entry(child->second))
      return nullptr;
    node = &child->second;
  }
  return node;
}

const DeclaredEntries::Tree& DeclaredEntries::at(const std::vector<std::string>& path,
                                                 const std::string& entry) const
{
  return at(path)->find(entry)->second;
}

bool DeclaredEntries::has_section(const std::vector<std::string>& path) const
{
  return at(path) != nullptr;
}

bool DeclaredEntries::has_entry(const std::vector<std::string>& path,
                                const std::string& entry) const
{
  const Tree* section = at(path);
  const auto child = section == nullptr ? tree.not_found() : section->find(entry);
  return section != nullptr && child != section->not_found() && is_entry(child->second);
}

std::vector<std::string> DeclaredEntries::sections(const std::vector<std::string>& path) const
{
  return names(at(path), false);
}

std::vector<std::string> DeclaredEntries::entries(const std::vector<std::string>& path) const
{
  return names(at(path), true);
}

std::string DeclaredEntries::value(const std::vector<std::string>& path,
                                   const std::string& entry) const
{
  return at(path, entry).get<std::string>("value");
}

std::vector<std::string> DeclaredEntries::changed(const std::vector<std::string>& path) const
{
  std::vector<std::string> result;
  for (const std::string& entry : entries(path))
    if (value(path, entry) != at(path, entry).get<std::string>("default_value"))
      result.push_back(entry);
  return result;
}

std::string DeclaredEntries::pattern(const std::vector<std::string>& path,
                                     const std::string& entry) const
{
  return at(path, entry).get<std::string>("pattern_description");
}

std::vector<std::string> DeclaredEntries::sections_with(const std::string& entry) const
{
  std::vector<std::string> found;
  find(tree, entry, "", found);
  return found;
}

} // namespace thelma
