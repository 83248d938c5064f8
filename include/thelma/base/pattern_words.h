#pragma once

#include <string>
#include <vector>

namespace thelma
{

/// What the description of a deal.II pattern lets choose from, if it does.
std::vector<std::string> choices(const std::string& pattern);

/// The description of a pattern in words.
std::string in_words(const std::string& pattern);

} // namespace thelma
