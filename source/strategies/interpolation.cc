#include <thelma/strategies/interpolation.h>

namespace thelma
{

std::vector<double> weights(const std::vector<double>& places, const double place,
                            const Parity parity)
{
  const auto abscissa = [&](const double s) { return parity == Parity::none ? s : s * s; };
  const auto is_zero = [&](const double s) {
    return parity == Parity::odd && s == 0.; // known without being asked
  };
  std::vector<double> result;
  for (const double& a : places) {
    double weight = is_zero(a) ? 0. : parity == Parity::odd ? place / a : 1.;
    for (const double& b : places)
      if (&a != &b && !is_zero(b))
        weight *= (abscissa(place) - abscissa(b)) / (abscissa(a) - abscissa(b));
    result.push_back(weight);
  }
  return result;
}

} // namespace thelma
