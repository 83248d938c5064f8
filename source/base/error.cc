#include <thelma/base/error.h>

namespace thelma
{

std::string comma_separated(const std::vector<std::string>& words)
{
  std::string result;
  for (const std::string& word : words)
    result += (result.empty() ? "" : ", ") + word;
  return result.empty() ? "none" : result;
}

} // namespace thelma
