#pragma once

#include <thelma/base/formula.h>

#include <map>
#include <memory>
#include <string>

namespace thelma
{

/// A multiple over time: a muParser expression of t in s, or a table `time: value, time: value`
/// with straight lines between its rows and constants beyond them.
class Amplitude
{
public:
  /// Throws InputError, with @p place in the sentence, if @p text is neither.
  Amplitude(const std::string& place, const std::string& text);

  double operator()(double time) const;

  /// The times in s at which it has kinks.
  const std::map<double, double>& table() const { return rows; }

private:
  std::map<double, double> rows;
  std::shared_ptr<const Formula<1>> formula;
};

} // namespace thelma
