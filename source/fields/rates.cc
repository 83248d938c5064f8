#include <thelma/fields/rates.h>

#include <algorithm>

namespace thelma
{

Rates backward_differences(const double time, const std::vector<double>& times,
                           const unsigned int order)
{
  const std::size_t n = times.size();
  Rates rates;
  rates.order = order;
  rates.n_past = std::min<std::size_t>(order, n);
  const double h = time - times[n - 1];
  if (rates.n_past == 1) {
    rates.weights = {{1. / h, -1. / h, 0.}};
    return rates;
  }
  const double H = time - times[n - 2];
  rates.weights[1] = -H / (h * (H - h));
  rates.weights[2] = h / (H * (H - h));
  rates.weights[0] = -rates.weights[1] - rates.weights[2];
  return rates;
}

} // namespace thelma
