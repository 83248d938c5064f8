#pragma once

#include <thelma/base/formula.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace thelma
{

/// Components that may change over the undeformed body and in time, as a parameter file gives them
/// with blanks between: numbers, with a unit behind the last one if it is not that of the entry, or
/// muParser expressions of x1, x2, x3 (in the plane x1, x3; mm) and t (s) in the unit of the entry.
template <int dim>
class Distribution
{
public:
  /// What to add to an entry's sentence.
  static constexpr const char* sentence =
      dim == 3 ? "Numbers or expressions of x1, x2, x3 (mm, undeformed) and t (s), without commas"
               : "Numbers or expressions of x1, x3 (mm, undeformed) and t (s), without commas";

  /// @p n components in the @p unit. Throws InputError, with a sentence without place.
  Distribution(const std::string& text, unsigned int n, const std::string& unit);

  bool changes_in_time() const { return in_time; }

  double operator()(unsigned int component, const dealii::Point<dim>& X, double time) const;

private:
  void read_numbers(const std::vector<std::string>& words, const std::string& unit);

  std::vector<double> numbers;
  std::vector<std::shared_ptr<Formula<dim>>> formulas; ///< in place of numbers
  bool in_time = false;
};

/// Those of regions or surfaces, by their names.
template <int dim>
using Distributions = std::map<std::string, Distribution<dim>>;

/// Declare the @p entry, `name: components, name: components`, each of @p n in the @p unit; the
/// @p sentence need not name that.
template <int dim>
void add_distributions(dealii::ParameterHandler& prm, const std::string& entry,
                       Distributions<dim>& values, const std::string& sentence, unsigned int n,
                       const std::string& unit);

template <int dim>
bool change_in_time(const Distributions<dim>& values);

} // namespace thelma
