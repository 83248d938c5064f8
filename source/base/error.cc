#include <thelma/base/error.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <sstream>

namespace thelma
{
namespace
{

/// Letters to insert, remove, replace or swap with their neighbour to make @p b of @p a; capitals
/// do not count.
std::size_t edits(const std::string& a, const std::string& b)
{
  const auto same = [&](const std::size_t i, const std::size_t j) {
    return std::tolower(static_cast<unsigned char>(a[i])) ==
           std::tolower(static_cast<unsigned char>(b[j]));
  };
  std::vector<std::size_t> before, row(b.size() + 1), next(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    next[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      next[j + 1] = std::min({row[j] + (same(i, j) ? 0 : 1), row[j + 1] + 1, next[j] + 1});
      if (i > 0 && j > 0 && same(i, j - 1) && same(i - 1, j))
        next[j + 1] = std::min(next[j + 1], before[j - 1] + 1);
    }
    before = row;
    row = next;
  }
  return row.back();
}

std::string joined(const std::vector<std::string>& sentences)
{
  std::string text;
  for (const std::string& sentence : sentences)
    text += (text.empty() ? "" : "\n") + sentence;
  return text;
}

} // namespace

InputError::InputError(const std::vector<std::string>& sentences)
    : std::runtime_error(joined(sentences))
{
}

std::string as_text(const double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::vector<std::string> InputError::sentences() const
{
  std::vector<std::string> result;
  std::istringstream text(what());
  for (std::string line; std::getline(text, line);)
    result.push_back(line);
  return result;
}

std::string comma_separated(const std::vector<std::string>& words)
{
  std::string result;
  for (const std::string& word : words) {
    const bool is_odd = word.find_first_of(",:") != std::string::npos;
    result += (result.empty() ? "" : ", ") + (is_odd ? "'" + word + "'" : word);
  }
  return result.empty() ? "none" : result;
}

std::string closest(const std::string& word, const std::vector<std::string>& known)
{
  std::string best;
  std::size_t fewest = std::max<std::size_t>(1, std::min<std::size_t>(word.size(), 60) / 3) + 1;
  if (word.size() < 60)
    for (const std::string& candidate : known)
      if (const std::size_t n = edits(word, candidate); n < fewest) {
        fewest = n;
        best = candidate;
      }
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known)
{
  const std::string guess = closest(word, known);
  return (guess.empty() ? "; known: " : "; did you mean '" + guess + "'? Known: ") +
         comma_separated(known);
}

} // namespace thelma
