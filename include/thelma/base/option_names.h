#pragma once

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// Names of the values that an entry of a parameter file may have.
template <typename Option>
class OptionNames
{
public:
  OptionNames(std::vector<std::pair<std::string, Option>> options) : options(std::move(options)) {}

  /// Declare the @p entry, which writes what it reads into @p value; as that stands is the default.
  void declare(dealii::ParameterHandler& prm, const std::string& entry, Option& value,
               const std::string& text) const
  {
    std::string names;
    for (const auto& option : options)
      names += (names.empty() ? "" : "|") + option.first;
    prm.declare_entry(entry, name(value), dealii::Patterns::Selection(names), text);
    prm.add_action(entry, [&value, options = options](const std::string& read) {
      value = std::find_if(options.begin(), options.end(), [&](const auto& option) {
                return option.first == read;
              })->second;
    });
  }

  const std::string& name(const Option value) const
  {
    return std::find_if(options.begin(), options.end(),
                        [&](const auto& option) { return option.second == value; })
        ->first;
  }

private:
  std::vector<std::pair<std::string, Option>> options;
};

} // namespace thelma
