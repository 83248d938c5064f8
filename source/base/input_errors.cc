#include <thelma/base/input_errors.h>

#include <algorithm>
#include <regex>

namespace thelma
{

void InputErrors::add(const std::string& sentence)
{
  if (std::find(list.begin(), list.end(), sentence) == list.end())
    list.push_back(sentence);
}

void InputErrors::add_unexplained(const InputErrors& found)
{
  const std::vector<std::string> earlier = list;
  for (const std::string& sentence : found.sentences()) {
    const std::string entry = sentence.substr(0, sentence.find(':')),
                      section = sentence.substr(0, sentence.find_first_of(",:/")),
                      guess = "did you mean '" + section.substr(section.find(' ') + 1) + "'";
    const auto explains = [&](const std::string& other) {
      const auto has = [&](const std::string& text) {
        return other.find(text) != std::string::npos;
      };
      std::smatch unread;
      std::regex_search(other, unread, std::regex("section [^:]*, entry '[^']*'"));
      return has(entry) || has(guess) || (has(section) && (has("unknown ") || has("be one of "))) ||
             (!unread.empty() && sentence.find(unread.str()) != std::string::npos);
    };
    if (std::none_of(earlier.begin(), earlier.end(), explains))
      add(sentence);
  }
}

void InputErrors::raise() const
{
  if (!list.empty())
    throw InputError(list);
}

} // namespace thelma
