#include <thelma/base/distribution.h>
#include <thelma/base/error.h>
#include <thelma/base/quantity.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdlib>
#include <regex>

namespace thelma
{
namespace
{

/// Whether it begins with a number that only a unit may follow.
bool is_quantity(const std::string& text)
{
  static const std::string operators = "-+*/^.0123456789<>=!&|?(";
  char* behind = nullptr; // the number
  std::strtod(text.c_str(), &behind);
  const std::string rest = dealii::Utilities::trim(behind);
  return behind != text.c_str() && (rest.empty() || operators.find(rest[0]) == std::string::npos);
}

/// The first @p n words of @p text, and what follows behind the last of them; all of it where there
/// is one only.
std::vector<std::string> split(const std::string& text, const unsigned int n)
{
  std::vector<std::string> words{dealii::Utilities::trim(text)};
  while (words.size() < n) {
    const std::string rest = words.back();
    const std::size_t blank = rest.find(' ');
    if (blank == std::string::npos)
      return words;
    words.back() = rest.substr(0, blank);
    words.push_back(dealii::Utilities::trim(rest.substr(blank)));
  }
  return words;
}

} // namespace

template <int dim>
Distribution<dim>::Distribution(const std::string& text, const unsigned int n,
                                const std::string& unit)
{
  const std::vector<std::string> words = split(text, n);
  const std::string remedy = "; write " +
                             (n == 1 ? "a number or an expression"
                                     : std::to_string(n) + " components with blanks between") +
                             (unit == "1" ? "" : " in " + unit);
  if (words.size() < n || words.back().empty())
    throw InputError("'" + text + "' has too few components" + remedy);
  bool all = true;
  for (const std::string& word : words)
    all = all && is_quantity(word);
  if (all) {
    read_numbers(words, unit);
    return;
  }
  if (n > 1 && words.back().find(' ') != std::string::npos)
    throw InputError("'" + text + "' has too many components" + remedy +
                     ", and each expression without blanks");
  for (const std::string& word : words) {
    formulas.push_back(
        std::make_shared<Formula<dim>>("", word, dim == 3 ? "x1,x2,x3,t" : "x1,x3,t"));
    in_time = in_time || std::regex_search(word, std::regex("(^|[^A-Za-z0-9_])t($|[^A-Za-z0-9_])"));
  }
}

template <int dim>
void Distribution<dim>::read_numbers(const std::vector<std::string>& words, const std::string& unit)
{
  char* behind = nullptr; // the last number
  std::strtod(words.back().c_str(), &behind);
  for (std::size_t c = 0; c < words.size(); ++c)
    numbers.push_back(Quantity(unit).value(c + 1 < words.size() ? words[c] + behind : words[c]));
}

template <int dim>
double Distribution<dim>::operator()(const unsigned int component, const dealii::Point<dim>& X,
                                     const double time) const
{
  return formulas.empty() ? numbers[component] : formulas[component]->at(X, time);
}

template <int dim>
void add_distributions(dealii::ParameterHandler& prm, const std::string& entry,
                       Distributions<dim>& values, const std::string& sentence,
                       const unsigned int n, const std::string& unit)
{
  using namespace dealii::Patterns;
  using Texts = std::map<std::string, std::string>;
  prm.declare_entry(entry, "", Map(Anything(), Anything(), 0, 100),
                    sentence + ". " + Distribution<dim>::sentence + ". Unit: " + unit + ".");
  prm.add_action(entry, [&values, n, unit](const std::string& text) {
    values.clear();
    for (const auto& [name, components] : Tools::Convert<Texts>::to_value(text))
      values.emplace(name, Distribution<dim>(components, n, unit));
  });
}

template <int dim>
bool change_in_time(const Distributions<dim>& values)
{
  return std::any_of(values.begin(), values.end(),
                     [](const auto& value) { return value.second.changes_in_time(); });
}

template class Distribution<2>;
template class Distribution<3>;
template void add_distributions(dealii::ParameterHandler&, const std::string&, Distributions<2>&,
                                const std::string&, unsigned int, const std::string&);
template void add_distributions(dealii::ParameterHandler&, const std::string&, Distributions<3>&,
                                const std::string&, unsigned int, const std::string&);
template bool change_in_time(const Distributions<2>&);
template bool change_in_time(const Distributions<3>&);

} // namespace thelma
