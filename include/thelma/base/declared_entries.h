#pragma once

#include <deal.II/base/parameter_handler.h>

#include <boost/property_tree/ptree.hpp>

#include <string>
#include <vector>

namespace thelma
{

/// The sections and entries that a ParameterHandler knows.
class DeclaredEntries
{
public:
  explicit DeclaredEntries(const dealii::ParameterHandler& prm);

  bool has_section(const std::vector<std::string>& path) const;
  bool has_entry(const std::vector<std::string>& path, const std::string& entry) const;

  std::vector<std::string> sections(const std::vector<std::string>& path) const;
  std::vector<std::string> entries(const std::vector<std::string>& path) const;

  /// As it was last set.
  std::string value(const std::vector<std::string>& path, const std::string& entry) const;

  /// Entries of a section whose values are not the defaults.
  std::vector<std::string> changed(const std::vector<std::string>& path) const;

  /// The description() of an entry's pattern.
  std::string pattern(const std::vector<std::string>& path, const std::string& entry) const;

  /// Sections, written with slashes, that have an entry of this name.
  std::vector<std::string> sections_with(const std::string& entry) const;

private:
  using Tree = boost::property_tree::ptree;

  const Tree* at(const std::vector<std::string>& path) const;
  const Tree& at(const std::vector<std::string>& path, const std::string& entry) const;

  Tree tree;
};

} // namespace thelma
