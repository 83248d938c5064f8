#pragma once

#include <thelma/base/formula.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace thelma
{

/// Times in s at which an amplitude has kinks or is about to jump, and between which it is nearly
/// straight.
struct AmplitudeTimes {
  std::vector<double> kinks, bends;
};

/// A multiple over time: a muParser expression of t in s, or a table `time: value, time: value`
/// with straight lines between its rows and constants beyond them.
class Amplitude
{
public:
  /// Throws InputError, with @p place in the sentence, if @p text is neither.
  Amplitude(const std::string& place, const std::string& text);

  double operator()(double time) const;

  /// What steps up to @p end (s) must not step over. Throws InputError if it is not finite there.
  AmplitudeTimes times(double end) const;

private:
  AmplitudeTimes times_of_formula(double end) const;

  std::string place, text;
  std::map<double, double> rows;
  std::shared_ptr<const Formula<1>> formula;
};

} // namespace thelma
