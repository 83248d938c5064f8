#include <thelma/strategies/temperature_weights.h>

#include <utility>

namespace thelma
{

/// Least squares by Gram and Schmidt, from the newest change of temperature to the oldest; one that
/// is almost made of the others says nothing.
std::vector<double> temperature_weights(const std::vector<State::Accepted>& path,
                                        const BlockVector::BlockType& theta, const unsigned int b)
{
  constexpr double negligible = 1e-4;
  const std::size_t n = path.size();
  const auto difference = [&](const auto& x, const auto& y) {
    auto d = x;
    d -= y;
    d.zero_out_ghost_values();
    return d;
  };
  auto rest = difference(theta, path.back().x.block(b));
  std::vector<decltype(rest)> basis;
  std::vector<std::vector<double>> coefficients; // of the states in each vector of the basis
  std::vector<double> weights(n, 0.);
  weights.back() = 1.;
  for (std::size_t k = n - 1; k-- > 0;) {
    auto v = difference(path[k + 1].x.block(b), path[k].x.block(b));
    std::vector<double> c(n, 0.);
    c[k + 1] = 1.;
    c[k] = -1.;
    const double length = v.l2_norm();
    for (std::size_t m = 0; m < basis.size(); ++m) {
      const double part = v * basis[m];
      v.add(-part, basis[m]);
      for (std::size_t i = 0; i < n; ++i)
        c[i] -= part * coefficients[m][i];
    }
    const double left = v.l2_norm();
    if (!(left > negligible * length))
      continue;
    v /= left;
    for (double& value : c)
      value /= left;
    const double part = rest * v;
    rest.add(-part, v);
    for (std::size_t i = 0; i < n; ++i)
      weights[i] += part * c[i];
    basis.push_back(std::move(v));
    coefficients.push_back(std::move(c));
  }
  return weights;
}

} // namespace thelma
