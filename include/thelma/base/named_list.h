#pragma once

#include <thelma/base/error.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// What a .prm can choose by name: each name with a factory. The lists are written out in one
/// visible place each (`*list.cc`); an unknown name is answered with the known ones.
template <typename Base>
class NamedList
{
public:
  using Factory = std::function<std::unique_ptr<Base>()>;

  /// @p kind begins the sentence about an unknown name, e.g. "unknown observable".
  NamedList(std::string kind, std::vector<std::pair<std::string, Factory>> entries)
      : kind(std::move(kind)), entries(std::move(entries))
  {
  }

  std::unique_ptr<Base> create(const std::string& name) const
  {
    for (const auto& [known, factory] : entries)
      if (known == name)
        return factory();
    throw InputError(kind + " '" + name + "'" + known_ones(name, names()));
  }

  std::vector<std::string> names() const
  {
    std::vector<std::string> result;
    for (const auto& entry : entries)
      result.push_back(entry.first);
    return result;
  }

private:
  std::string kind;
  std::vector<std::pair<std::string, Factory>> entries;
};

} // namespace thelma
