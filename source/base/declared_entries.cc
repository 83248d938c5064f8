#include <thelma/base/declared_entries.h>

#include <boost/property_tree/json_parser.hpp>

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
  std::stringstream json;
  prm.print_parameters(json, dealii::ParameterHandler::JSON);
  boost::property_tree::read_json(json, tree);
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

std::string DeclaredEntries::pattern(const std::vector<std::string>& path,
                                     const std::string& entry) const
{
  return at(path)->find(entry)->second.get<std::string>("pattern_description");
}

std::vector<std::string> DeclaredEntries::sections_with(const std::string& entry) const
{
  std::vector<std::string> found;
  find(tree, entry, "", found);
  return found;
}

} // namespace thelma
