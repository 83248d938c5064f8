#include <thelma/base/error.h>
#include <thelma/base/expression.h>
#include <thelma/base/wording.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace thelma
{

/// Recursive descent. What does not vary is computed at once, so that a sum or product of two has
/// two operands that vary.
class ExpressionReader
{
public:
  using What = Expression::What;
  using Step = Expression::Step;

  ExpressionReader(const std::string& text, const std::vector<std::string>& variables,
                   const std::map<std::string, double>& numbers)
      : text(text), variables(variables), numbers(numbers)
  {
  }

  std::vector<Step> read()
  {
    read_sum();
    if (next() != '\0')
      fail("it cannot be read from '" + text.substr(place) + "' on");
    check_depth();
    return steps;
  }

private:
  [[noreturn]] void fail(const std::string& why) const
  {
    throw InputError("'" + text + "' is no formula: " + why);
  }

  char next()
  {
    while (place < text.size() && std::isspace(static_cast<unsigned char>(text[place])))
      ++place;
    return place < text.size() ? text[place] : '\0';
  }

  bool take(const char symbol)
  {
    const bool found = next() == symbol;
    place += found ? 1 : 0;
    return found;
  }

  void read_sum()
  {
    const std::size_t left = steps.size();
    read_product();
    for (;;) {
      const std::size_t right = steps.size();
      if (take('-')) {
        read_product();
        combine(What::product, right, number_step(-1.));
      } else if (take('+'))
        read_product();
      else
        return;
      combine(What::sum, left, right);
    }
  }

  void read_product()
  {
    const std::size_t left = steps.size();
    read_factor();
    for (;;) {
      const std::size_t right = steps.size();
      if (take('/')) {
        read_factor();
        apply(What::power, right, -1.);
      } else if (take('*'))
        read_factor();
      else
        return;
      combine(What::product, left, right);
    }
  }

  /// A sign is weaker than a power: -x^2 is -(x^2).
  void read_factor()
  {
    constexpr unsigned int most = 100;
    if (++nested > most)
      fail("it is nested too deeply");
    const std::size_t start = steps.size();
    if (take('-')) {
      read_factor();
      combine(What::product, start, number_step(-1.));
    } else {
      take('+');
      read_atom();
      if (take('^'))
        read_exponent(start);
    }
    --nested;
  }

  /// Of the base that begins at @p start.
  void read_exponent(const std::size_t start)
  {
    const std::size_t exponent = steps.size();
    read_factor();
    if (!is_number(exponent, steps.size()))
      fail("an exponent depends on " + comma_separated(variables) + "; write exp(... * log(...))");
    const double p = steps.back().number;
    steps.pop_back();
    apply(What::power, start, p);
  }

  void read_atom()
  {
    const char symbol = next();
    if (take('(')) {
      read_sum();
      if (!take(')'))
        fail("a parenthesis is not closed");
    } else if (std::isdigit(static_cast<unsigned char>(symbol)) || symbol == '.') {
      const char* const begin = text.c_str() + place;
      char* end = nullptr;
      steps.push_back({What::number, std::strtod(begin, &end)});
      if (end == begin)
        fail("'" + text.substr(place) + "' does not begin with a number");
      place += end - begin;
    } else
      read_name();
  }

  void read_name()
  {
    const std::size_t begin = place;
    while (place < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[place])) || text[place] == '_'))
      ++place;
    const std::string name = text.substr(begin, place - begin);
    if (name.empty())
      fail(begin < text.size() ? "'" + text.substr(begin) + "' is not expected there"
                               : "a number or name is missing at its end");
    const std::size_t start = steps.size();
    const auto variable = std::find(variables.begin(), variables.end(), name);
    if (variable != variables.end())
      steps.push_back(
          {What::variable, 0., static_cast<unsigned int>(variable - variables.begin())});
    else if (const auto number = numbers.find(name); number != numbers.end())
      steps.push_back({What::number, number->second});
    else if (name == "exp" || name == "log" || name == "sqrt") {
      if (next() != '(')
        fail("'" + name + "' needs its argument in parentheses");
      read_atom();
      apply(name == "exp" ? What::exp : name == "log" ? What::log : What::power, start, 0.5);
    } else
      fail("unknown name '" + name + "'" + did_you_mean(name, known()));
  }

  std::vector<std::string> known() const
  {
    std::vector<std::string> names = variables;
    for (const auto& number : numbers)
      names.push_back(number.first);
    names.insert(names.end(), {"exp", "log", "sqrt"});
    return names;
  }

  bool is_number(const std::size_t begin, const std::size_t end) const
  {
    return end == begin + 1 && steps[begin].what == What::number;
  }

  std::size_t number_step(const double number)
  {
    steps.push_back({What::number, number});
    return steps.size() - 1;
  }

  /// A function of the operand that begins at @p start.
  void apply(const What what, const std::size_t start, const double p)
  {
    double& x = steps[start].number;
    if (!is_number(start, steps.size()))
      steps.push_back({what, p});
    else
      x = what == What::exp ? std::exp(x) : what == What::log ? std::log(x) : std::pow(x, p);
  }

  /// Sum or product of the operands that begin at @p left and @p right.
  void combine(const What what, const std::size_t left, const std::size_t right)
  {
    const bool is_sum = what == What::sum;
    const bool left_is_number = is_number(left, right),
               right_is_number = is_number(right, steps.size());
    if (!left_is_number && !right_is_number) {
      steps.push_back({what});
      return;
    }
    const double number = steps[right_is_number ? right : left].number;
    steps.erase(steps.begin() + (right_is_number ? right : left));
    if (double& x = steps[left].number; left_is_number && right_is_number)
      x = is_sum ? x + number : x * number;
    else
      steps.push_back({is_sum ? What::shift : What::scale, number});
  }

  void check_depth() const
  {
    std::size_t depth = 0;
    for (const Step& step : steps) {
      depth += step.what == What::number || step.what == What::variable ? 1 : 0;
      depth -= step.what == What::sum || step.what == What::product ? 1 : 0;
      if (depth > Expression::deepest)
        fail("its parentheses are nested too deeply; put the longer operand first");
    }
  }

  const std::string& text;
  const std::vector<std::string>& variables;
  const std::map<std::string, double>& numbers;
  std::vector<Step> steps;
  std::size_t place = 0;
  unsigned int nested = 0;
};

Expression::Expression(const std::string& text, const std::vector<std::string>& variables,
                       const std::map<std::string, double>& numbers)
    : steps(ExpressionReader(text, variables, numbers).read())
{
}

} // namespace thelma
