#include <thelma/base/rotation.h>
#include <thelma/strategies/path_direction.h>
#include <thelma/strategies/predictor.h>
#include <thelma/strategies/temperature_weights.h>

#include <algorithm>
#include <cmath>

namespace thelma
{
namespace
{

/// How the deformation gradient that continues the history @p F, newest last, differs from the
/// polynomial through its components.
Tensor3<2> rotation_effect(const std::vector<Tensor3<2>>& F, const std::vector<double>& weights)
{
  const PolarDecomposition newest(F.back());
  Tensor3<2> next = newest.R, U = weights.back() * newest.U, polynomial = weights.back() * F.back();
  Tensor3<1> turn, sum; // rotation vectors from the newest state
  for (std::size_t k = F.size() - 1; k-- > 0;) {
    const PolarDecomposition polar(F[k]);
    turn -= rotation_vector(next * dealii::transpose(polar.R));
    sum += weights[k] * turn;
    U += weights[k] * polar.U;
    polynomial += weights[k] * F[k];
    next = polar.R;
  }
  return rotation(sum) * newest.R * U - polynomial;
}

} // namespace

template <int dim>
void Predictor<dim>::setup(const Formulation<dim>& formulation_, const bool is_large)
{
  formulation = &formulation_;
  fit.emplace(layout, conditions, is_large);
  guess = layout.new_vector();
}

/// States so near each other that their difference is noise are passed over.
template <int dim>
typename Predictor<dim>::Supports Predictor<dim>::supports(const std::vector<double>& places,
                                                           const double place) const
{
  constexpr double near = 1e-3;
  const double newest = places.back();
  Supports found{{newest}, {state.path().back()}};
  for (std::size_t k = places.size() - 1; k-- > 0 && found.places.size() <= order;)
    if (found.places.front() - places[k] > near * std::abs(place - newest)) {
      found.places.insert(found.places.begin(), places[k]);
      found.states.insert(found.states.begin(), state.path()[k]);
    }
  return found;
}

/// The guess at @p place of the highest order that does not point back; returns its load.
template <int dim>
double Predictor<dim>::extrapolate(Supports path, const double place, const Parity parity,
                                   const PathMetric* metric)
{
  for (;;) {
    const std::vector<double> even = weights(path.places, place, parity);
    double load = 0.;
    for (std::size_t k = 0; k < even.size(); ++k)
      load += even[k] * path.states[k].load;
    combine(path.states, even,
            parity == Parity::even ? weights(path.places, place, Parity::odd) : even);
    if (path.states.size() <= 2 || place <= path.places.back() ||
        !turns_back(path, place, load, metric))
      return load;
    path.places.erase(path.places.begin());
    path.states.erase(path.states.begin());
  }
}

/// Whether the guess at @p place, at @p load, goes elsewhere than the last step went.
template <int dim>
bool Predictor<dim>::turns_back(const Supports& path, const double place, const double load,
                                const PathMetric* metric) const
{
  const std::size_t n = path.places.size();
  const State::Accepted &before = path.states[n - 2], &last = path.states[n - 1];
  const double ratio = (place - path.places[n - 1]) / (path.places[n - 1] - path.places[n - 2]);
  return !goes_on(before, last, guess, load, metric) &&
         !deforms_on(layout, fit->points(), {{&before.x, &last.x, &guess}}, ratio);
}

template <int dim>
void Predictor<dim>::predict(const double load, const LoadSymmetry symmetry)
{
  std::vector<double> loads;
  loads.reserve(state.path().size());
  for (const State::Accepted& accepted : state.path())
    loads.push_back(accepted.load);
  const Parity parity = symmetry == LoadSymmetry::voltage ? Parity::even : Parity::none;
  extrapolate(supports(loads, load), load, parity, nullptr);
}

template <int dim>
double Predictor<dim>::extrapolate_along(const std::vector<double>& places, const double place,
                                         const PathMetric& metric)
{
  return extrapolate(supports(places, place), place, Parity::none, &metric);
}

template <int dim>
void Predictor<dim>::between(const State::Accepted& found, const double part)
{
  const std::vector<double> weights{1. - part, part};
  combine({state.path().back(), found}, weights, weights);
}

template <int dim>
void Predictor<dim>::combine(const std::vector<State::Accepted>& path,
                             const std::vector<double>& even, const std::vector<double>& odd)
{
  for (unsigned int b = 0; b < state.x.n_blocks(); ++b) {
    const bool potential = layout.has(Field::potential) && b == layout.block(Field::potential);
    state.x.block(b) = 0.;
    for (std::size_t k = 0; k < path.size(); ++k)
      state.x.block(b).add(potential ? odd[k] : even[k], path[k].x.block(b));
  }
  if (path.size() > 1)
    fit->add([&](const std::vector<Tensor3<2>>& F) { return rotation_effect(F, even); }, path,
             state.x);
  state.x.update_ghost_values();
  follow_cells(path, even);
  guess = state.x;
}

/// The internal unknowns, as seen from the cells at the guess.
template <int dim>
void Predictor<dim>::follow_cells(const std::vector<State::Accepted>& path,
                                  const std::vector<double>& weights)
{
  const unsigned int n = formulation->n_internal();
  state.internal.assign(state.internal.size(), 0.);
  if (n == 0)
    return;
  std::vector<double> x, values(n);
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    double* guessed = state.internal.data() + index * n;
    const auto view = [&](const BlockVector& iterate) {
      layout.gather(cell, iterate, x);
      return CellView<dim>{index,   cell,        x.data(),
                           nullptr, state.theta, layout.has(Field::temperature)};
    };
    for (std::size_t k = 0; k < path.size(); ++k) {
      std::copy_n(path[k].internal.begin() + index * n, n, values.begin());
      formulation->pull_back(view(path[k].x), values.data());
      for (unsigned int i = 0; i < n; ++i)
        guessed[i] += weights[k] * values[i];
    }
    formulation->push_forward(view(state.x), guessed);
  }
}

template <int dim>
void Predictor<dim>::follow_temperature()
{
  const std::size_t known = std::min<std::size_t>(state.path().size(), order + 1);
  const std::vector<State::Accepted> path(state.path().end() - known, state.path().end());
  const unsigned int b = layout.block(Field::temperature);
  const auto theta = state.x.block(b);
  const std::vector<double> weights = temperature_weights(path, theta, b);
  combine(path, weights, weights);
  state.x.block(b) = theta;
  state.x.update_ghost_values();
}

template <int dim>
double Predictor<dim>::prediction_error() const
{
  if (state.path().size() < 2)
    return 0.; // nothing was foretold
  auto correction = state.x.block(0), step = state.x.block(0);
  correction -= guess.block(0);
  step -= state.path().back().x.block(0);
  const double length = step.l2_norm();
  return length > 0. ? correction.l2_norm() / length : 0.;
}

/// Grown by one with each state, an order never reaches back past where the path has turned.
template <int dim>
void Predictor<dim>::adapt(const double prediction_error)
{
  constexpr double trusted = 0.3;
  if (std::isinf(prediction_error))
    order = std::min(order, 1u);
  else
    order = prediction_error > trusted ? 1 : std::min(order + 1, highest_order);
}

template class Predictor<2>;
template class Predictor<3>;

} // namespace thelma
