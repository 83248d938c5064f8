#pragma once

#include <array>
#include <optional>
#include <string>

namespace thelma
{

/// What a unit measures, as exponents of m, kg, s, A and K, and how large it is in SI units.
struct Unit {
  std::array<int, 5> dimension{};
  double factor = 1.;
  double zero = 0.; ///< where the scale begins, in SI units: 273.15 for degC

  /// Products of symbols with SI prefixes, as "kV", "N/kV^2", "W/(m K)", "degC"; "1" and "" are the
  /// number. Nothing if @p text is no unit.
  static std::optional<Unit> parse(const std::string& text);
};

/// The symbols that parse() knows and what it makes of them, for a sentence about one it does not.
std::string known_units();

/// "a voltage", "a pressure", ...; in SI units where there is no name for it.
std::string name_of_dimension(const std::array<int, 5>& dimension);

/// The number that begins @p text and what follows it, without blanks at its ends. Throws
/// InputError, with @p example in the sentence, if there is no finite number.
struct NumberWithUnit {
  NumberWithUnit(const std::string& text, const std::string& example);

  double number;
  std::string unit;
};

} // namespace thelma
