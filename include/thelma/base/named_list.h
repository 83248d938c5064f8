#pragma once

#include <thelma/base/error.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// What a .prm can choose, and what that is in a few words.
struct Choice {
  std::string name, meaning;
};

/// What a .prm can choose by name: each choice with a factory, which takes @p Arguments. The lists
/// are written out in one visible place each (`*list.cc`); an unknown name is answered with the
/// known ones.
template <typename Base, typename... Arguments>
class NamedList
{
public:
  struct Entry : Choice {
    std::function<std::unique_ptr<Base>(Arguments...)> factory;
  };

  /// @p kind begins the sentence about an unknown name, e.g. "unknown observable".
  NamedList(std::string kind, std::vector<Entry> entries)
      : kind(std::move(kind)), entries(std::move(entries))
  {
  }

  /// Throws InputError if the name is unknown.
  std::unique_ptr<Base> create(const std::string& name, const Arguments&... arguments) const
  {
    require(name);
    return find(name)->factory(arguments...);
  }

  bool has(const std::string& name) const { return find(name) != entries.end(); }

  /// Throws InputError if the name is unknown.
  void require(const std::string& name) const
  {
    if (!has(name))
      throw InputError(kind + " '" + name + "'" + did_you_mean(name, names()));
  }

  std::vector<std::string> names() const
  {
    std::vector<std::string> result;
    for (const Entry& entry : entries)
      result.push_back(entry.name);
    return result;
  }

  std::vector<Choice> choices() const { return {entries.begin(), entries.end()}; }

private:
  typename std::vector<Entry>::const_iterator find(const std::string& name) const
  {
    return std::find_if(entries.begin(), entries.end(),
                        [&](const Entry& entry) { return entry.name == name; });
  }

  std::string kind;
  std::vector<Entry> entries;
};

} // namespace thelma
