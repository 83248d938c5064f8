#pragma once

#include <thelma/base/error.h>

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

/// What a .prm can choose by name: each choice with a factory. The lists are written out in one
/// visible place each (`*list.cc`); an unknown name is answered with the known ones.
template <typename Base>
class NamedList
{
public:
  struct Entry : Choice {
    std::function<std::unique_ptr<Base>()> factory;
  };

  /// @p kind begins the sentence about an unknown name, e.g. "unknown observable".
  NamedList(std::string kind, std::vector<Entry> entries)
      : kind(std::move(kind)), entries(std::move(entries))
  {
  }

  std::unique_ptr<Base> create(const std::string& name) const
  {
    for (const Entry& entry : entries)
      if (entry.name == name)
        return entry.factory();
    throw InputError(kind + " '" + name + "'" + known_ones(name, names()));
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
  std::string kind;
  std::vector<Entry> entries;
};

} // namespace thelma
