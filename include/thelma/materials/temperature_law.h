#pragma once

#include <thelma/base/quantity.h>
#include <thelma/materials/temperature_table.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace thelma
{

/// A material parameter that depends on temperature, f(theta) = c_0 + c_1 x + c_2 x^2 + ... with
/// x = 1000 K / theta (the form of the paper's shear modulus), of which one coefficient is a
/// constant; or a table.
class TemperatureLaw
{
public:
  explicit TemperatureLaw(std::vector<double> coefficients) : c(std::move(coefficients)) {}

  /// Declares @p entry in the section @p prm stands in; @p what is the rest of the sentence
  /// "Coefficients ... of <what>".
  void declare(dealii::ParameterHandler& prm, const std::string& entry, const std::string& what,
               const Quantity& quantity);

  /// Neither coefficients nor table, which is an entry's default only.
  bool empty() const { return c.empty() && table.empty(); }

  TemperatureLaw times(double factor) const;

  /// If the table does not reach @p theta, what follows the section in a sentence that says so:
  /// `, entry 'Shear modulus': the table is from 293 to 350 K`; else empty.
  std::string table_defect(double theta) const;

  template <typename Number>
  Number value(const Number& theta) const
  {
    if (!table.empty())
      return table.value(theta);
    const Number x = 1000. / theta;
    Number f = c.back();
    for (std::size_t n = c.size() - 1; n > 0; --n)
      f = f * x + c[n - 1];
    return f;
  }

  /// df/dtheta: x^n has the derivative -n x^n / theta.
  template <typename Number>
  Number slope(const Number& theta) const
  {
    if (!table.empty())
      return table.slope(theta);
    const Number x = 1000. / theta;
    Number f = 0.;
    for (std::size_t n = c.size() - 1; n > 0; --n)
      f = (f + double(n) * c[n]) * x;
    return -f / theta;
  }

  /// d2f/dtheta2: x^n has the second derivative n (n + 1) x^n / theta^2.
  template <typename Number>
  Number curvature(const Number& theta) const
  {
    if (!table.empty())
      return table.curvature(theta);
    const Number x = 1000. / theta;
    Number f = 0.;
    for (std::size_t n = c.size() - 1; n > 0; --n)
      f = (f + double(n * (n + 1)) * c[n]) * x;
    return f / (theta * theta);
  }

private:
  std::vector<double> c;
  TemperatureTable table; ///< empty: the coefficients hold
  std::string entry;
};

/// mu(theta) in MPa of Sharma, Khurana and Joglekar, section 4.
inline std::vector<double> paper_shear_modulus()
{
  return {1.5180 / 3., -1.078 / 3., 0.2001 / 3.};
}

} // namespace thelma
