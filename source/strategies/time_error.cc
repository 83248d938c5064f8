#include <thelma/strategies/time_error.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace thelma
{

/// The error as a combination of states: the share of the distance between one of them and the
/// polynomial through others.
template <int dim>
struct TimeError<dim>::Combination {
  unsigned int order;
  std::vector<double> of_accepted;
  double of_iterate, of_longer;
};

namespace
{

/// Weights of values at these @p times in minus the polynomial through them, at the time @p at.
std::vector<double> minus_polynomial(const std::vector<double>& times, const double at)
{
  std::vector<double> weights(times.size(), -1.);
  for (std::size_t a = 0; a < times.size(); ++a)
    for (std::size_t b = 0; b < times.size(); ++b)
      if (b != a)
        weights[a] *= (at - times[b]) / (times[a] - times[b]);
  return weights;
}

} // namespace

template <int dim>
std::optional<typename TimeError<dim>::Combination> TimeError<dim>::combination() const
{
  const auto& path = state.path();
  if (path.size() == 1 && !longer)
    return {};
  if (path.size() == 1) {
    const double share = first_error_share(state.time, longer->load);
    const std::vector<double> w = minus_polynomial({path[0].load, state.time}, longer->load);
    return Combination{1, {share * w[0]}, share * w[1], share};
  }
  const unsigned int possible = std::min<std::size_t>(order, path.size() - 1);
  const std::size_t first = path.size() - possible - 1;
  std::vector<double> times, newest;
  for (std::size_t k = 0; k < path.size(); ++k) {
    times.push_back(path[k].load);
    if (k >= first)
      newest.push_back(path[k].load);
  }
  const double share = error_share(state.time, times, possible);
  const std::vector<double> w = minus_polynomial(newest, state.time);
  Combination result{possible, std::vector<double>(first, 0.), share, 0.};
  for (const double weight : w)
    result.of_accepted.push_back(share * weight);
  return result;
}

/// Nothing where the temperature is prescribed, as at walls that jump.
template <int dim>
std::optional<StepError> TimeError<dim>::of_temperature() const
{
  const std::optional<Combination> error = combination();
  if (!error)
    return {};
  BlockVector sum = state.x;
  sum *= error->of_iterate;
  for (std::size_t k = 0; k < error->of_accepted.size(); ++k)
    sum.add(error->of_accepted[k], state.path()[k].x);
  if (error->of_longer != 0.)
    sum.add(error->of_longer, longer->x);
  sum.zero_out_ghost_values();
  conditions.constraints().set_zero(sum);
  const auto& theta = sum.block(layout.block(Field::temperature));
  return StepError{theta.l2_norm() / std::sqrt(static_cast<double>(theta.size())), error->order};
}

template <int dim>
std::optional<StepError> TimeError<dim>::of_memory(const unsigned int n_per_point) const
{
  const std::optional<Combination> error = combination();
  if (!error)
    return {};
  const std::vector<double> now = state.history();
  std::vector<double> own(2, 0.), sums(2); // squares, points
  for (std::size_t i = 0; i < now.size(); ++i) {
    double sum = error->of_iterate * now[i];
    for (std::size_t k = 0; k < error->of_accepted.size(); ++k)
      if (error->of_accepted[k] != 0.)
        sum += error->of_accepted[k] * state.path()[k].history[i];
    if (error->of_longer != 0.)
      sum += error->of_longer * longer->history[i];
    own[0] += sum * sum;
  }
  own[1] = double(now.size()) / n_per_point;
  dealii::Utilities::MPI::sum(own, layout.communicator(), sums);
  return StepError{sums[1] > 0. ? std::sqrt(sums[0] / sums[1]) : 0., error->order};
}

template class TimeError<2>;
template class TimeError<3>;

} // namespace thelma
