#include <thelma/base/error.h>
#include <thelma/materials/temperature_law.h>

namespace thelma
{

void TemperatureLaw::declare(dealii::ParameterHandler& prm, const std::string& name,
                             const std::string& what, const Quantity& quantity)
{
  entry = name;
  add_table_quantity(
      prm, entry, c,
      "Coefficients c_0, c_1, ... of powers of (1000 K / theta), or a table `theta: "
      "value, theta: value`, of " +
          what,
      quantity,
      [this](const std::vector<double>& temperatures, const std::vector<double>& numbers) {
        if (temperatures.empty()) {
          c = numbers;
          table = TemperatureTable();
        } else
          table = TemperatureTable(temperatures, numbers);
      });
}

TemperatureLaw TemperatureLaw::times(const double factor) const
{
  TemperatureLaw scaled = *this;
  for (double& coefficient : scaled.c)
    coefficient *= factor;
  scaled.table.scale(factor);
  return scaled;
}

std::string TemperatureLaw::table_defect(const double theta) const
{
  if (table.empty() || table.has(theta))
    return "";
  return ", entry '" + entry + "': the table is from " + as_text(table.first()) + " to " +
         as_text(table.last()) + " K";
}

} // namespace thelma
