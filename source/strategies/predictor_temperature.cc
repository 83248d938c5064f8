// What a change of temperature foretells of the deformation.

#include <thelma/strategies/predictor.h>

#include <algorithm>

namespace thelma
{

template <int dim>
std::vector<State::Accepted> Predictor<dim>::recent() const
{
  const std::size_t known = std::min<std::size_t>(state.path().size(), order + 1);
  return {state.path().end() - known, state.path().end()};
}

template <int dim>
void Predictor<dim>::follow_temperature()
{
  const std::vector<State::Accepted> path = recent();
  const unsigned int b = layout.block(Field::temperature);
  const auto theta = state.x.block(b);
  const std::vector<double> weights = temperature_weights(path);
  combine(path, weights, weights);
  state.x.block(b) = theta;
  state.x.update_ghost_values();
}

/// Least squares by Gram and Schmidt, from the newest change of temperature to the oldest; one that
/// is almost made of the others says nothing.
template <int dim>
std::vector<double>
Predictor<dim>::temperature_weights(const std::vector<State::Accepted>& path) const
{
  constexpr double negligible = 1e-4;
  const unsigned int b = layout.block(Field::temperature);
  const std::size_t n = path.size();
  const auto difference = [&](const auto& x, const auto& y) {
    auto d = x;
    d -= y;
    d.zero_out_ghost_values();
    return d;
  };
  auto rest = difference(state.x.block(b), path.back().x.block(b));
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

template void Predictor<2>::follow_temperature();
template void Predictor<3>::follow_temperature();

} // namespace thelma
