#pragma once

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace thelma
{

/// Pattern of a number in a unit. ParameterFile takes other units of the same dimension too (`20
/// um` where mm are declared) and hands the handler the plain number.
class Quantity final : public dealii::Patterns::PatternBase
{
public:
  explicit Quantity(std::string unit, double smallest = std::numeric_limits<double>::lowest(),
                    double largest = std::numeric_limits<double>::max());

  /// Of a difference of temperatures, which degC cannot give.
  Quantity of_difference() const;

  /// One that a temperature may precede, as in a table `273: 1, 293: 2`.
  Quantity at_temperatures() const;

  /// Whether @p text is a plain number between the limits, or one at a temperature.
  bool match(const std::string& text) const override;
  std::string description(OutputStyle style = Machine) const override;
  std::unique_ptr<dealii::Patterns::PatternBase> clone() const override;

  /// The number that @p written, with its unit or without, is in the declared unit. Throws
  /// InputError with a sentence without place.
  double value(const std::string& written) const;

  /// @p text, which belongs to an entry of the pattern @p description, with plain numbers in place
  /// of those with units; throws like value().
  static std::string plain(const std::string& text, const std::string& description);

  /// What to add to an entry's sentence.
  std::string unit_sentence() const { return " Unit: " + unit + "."; }

private:
  /// The quantity whose description() is within @p description, if there is one.
  static std::unique_ptr<Quantity> within(const std::string& description);

  std::string unit;
  double smallest, largest;
  bool is_difference = false, may_be_in_table = false;
};

/// Declare a number in a unit; the @p sentence need not name it.
void add_quantity(dealii::ParameterHandler& prm, const std::string& entry, double& value,
                  const std::string& sentence, const Quantity& quantity);

/// A list of at least @p least and at most @p most of them, `1, 2`.
void add_quantity(dealii::ParameterHandler& prm, const std::string& entry,
                  std::vector<double>& values, const std::string& sentence,
                  const Quantity& quantity, unsigned int least = 1, unsigned int most = 10);

/// Coefficients, `1, 2`, or a table of values at temperatures in K, `273: 1, 293: 2`; nothing where
/// that is the default. @p read gets the temperatures, of coefficients none, and the numbers.
using ReadTable = std::function<void(const std::vector<double>&, const std::vector<double>&)>;
void add_table_quantity(dealii::ParameterHandler& prm, const std::string& entry,
                        const std::vector<double>& coefficients, const std::string& sentence,
                        const Quantity& quantity, const ReadTable& read);

/// One for each name, `a: 1, b: 2`.
void add_quantity(dealii::ParameterHandler& prm, const std::string& entry,
                  std::map<std::string, double>& values, const std::string& sentence,
                  const Quantity& quantity);

} // namespace thelma
