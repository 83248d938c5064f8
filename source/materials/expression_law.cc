#include <thelma/base/error.h>
#include <thelma/materials/expression_law.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <map>
#include <vector>

namespace thelma
{

void ExpressionLaw::declare(dealii::ParameterHandler& prm)
{
  prm.declare_entry(
      "Energy", "mu/2*(I1 - 3 - 2*log(J)), mu: 0.0566", dealii::Patterns::Anything(),
      "W in MPa, a formula of the invariants I1 and I2 of C_EM, of J = det F_EM, of theta in K and "
      "of parameters, whose values follow as `name: value, name: value`; with + - * / ^, "
      "`exp`, `log` (natural) and `sqrt`. Its stress must vanish at rest (I1 = I2 = 3, J = 1); the "
      "entropic factor theta/theta_0 and the volumetric energy of K are added.");
  prm.add_action("Energy", [this](const std::string& text) { read(text); });
}

/// The formula, then `name: value` of each parameter.
void ExpressionLaw::read(const std::string& text)
{
  const std::vector<std::string> variables = {"I1", "I2", "J", "theta"};
  std::vector<std::string> parts = dealii::Utilities::split_string_list(text);
  if (parts.empty())
    throw InputError("it is empty; write an energy, as `mu/2*(I1 - 3 - 2*log(J)), mu: 0.05`");
  std::map<std::string, double> parameters;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t colon = parts[i].find(':');
    const std::string name = dealii::Utilities::trim(parts[i].substr(0, colon));
    if (colon == std::string::npos)
      throw InputError("'" + parts[i] + "' has no value; after the formula write `name: value`");
    if (std::find(variables.begin(), variables.end(), name) != variables.end() ||
        parameters.count(name) > 0)
      throw InputError("'" + name + "' has a meaning already; choose another name");
    try {
      parameters[name] = dealii::Utilities::string_to_double(parts[i].substr(colon + 1));
    } catch (const dealii::ExceptionBase&) {
      throw InputError("the value of '" + parts[i] + "' is not a number");
    }
  }
  formula = Expression(parts[0], variables, parameters);
}

double ExpressionLaw::shear_modulus(const double theta) const
{
  const Tensor3<2> at_rest({{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}});
  const Jet<double, 4> w = energy(Invariants<double>(at_rest, 1.), theta);
  return 2. * (w.first[0] + w.first[1]);
}

} // namespace thelma
