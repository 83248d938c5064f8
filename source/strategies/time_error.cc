#include <thelma/strategies/time_error.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace thelma
{
namespace
{

/// The fields at a time in s.
struct Moment {
  double time;
  const BlockVector* x;
};

/// The temperature at one moment less the polynomial through others: root mean square over the
/// nodes (K), nothing where it is prescribed, as at walls that jump.
template <int dim>
double distance(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
                const Moment& moment, const std::vector<Moment>& others)
{
  BlockVector difference = *moment.x;
  for (const Moment& a : others) {
    double weight = 1.;
    for (const Moment& b : others)
      if (b.time != a.time)
        weight *= (moment.time - b.time) / (a.time - b.time);
    difference.add(-weight, *a.x);
  }
  difference.zero_out_ghost_values();
  conditions.constraints().set_zero(difference);
  const auto& theta = difference.block(layout.block(Field::temperature));
  return theta.l2_norm() / std::sqrt(static_cast<double>(theta.size()));
}

} // namespace

template <int dim>
std::optional<StepError> temperature_error(const DofLayout<dim>& layout,
                                           const BoundaryConditions<dim>& conditions,
                                           const State& state, const TimeScheme& scheme,
                                           const std::optional<State::Accepted>& longer)
{
  const auto& path = state.path();
  const Moment now = {state.time, &state.x};
  if (path.size() == 1 && !longer)
    return {};
  if (path.size() == 1) {
    const double share = first_error_share(state.time, longer->load);
    return StepError{
        share * distance(layout, conditions, {longer->load, &longer->x}, {{0., &path[0].x}, now}),
        1};
  }
  const unsigned int possible = std::min<std::size_t>(scheme.order, path.size() - 1);
  std::vector<double> times;
  std::vector<Moment> newest;
  for (std::size_t k = 0; k < path.size(); ++k) {
    times.push_back(path[k].load);
    if (k + possible + 1 >= path.size())
      newest.push_back({path[k].load, &path[k].x});
  }
  return StepError{error_share(scheme, state.time, times, possible) *
                       distance(layout, conditions, now, newest),
                   possible};
}

template std::optional<StepError> temperature_error(const DofLayout<2>&,
                                                    const BoundaryConditions<2>&, const State&,
                                                    const TimeScheme&,
                                                    const std::optional<State::Accepted>&);
template std::optional<StepError> temperature_error(const DofLayout<3>&,
                                                    const BoundaryConditions<3>&, const State&,
                                                    const TimeScheme&,
                                                    const std::optional<State::Accepted>&);

} // namespace thelma
