#include <thelma/assembly/predictor.h>
#include <thelma/base/rotation.h>
#include <thelma/elements/integrate.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
void Predictor<dim>::setup(const Formulation<dim>& formulation_, const bool large)
{
  formulation = &formulation_;
  is_large = large;
  full.emplace(layout, layout.degree() + 1);
  reduced.emplace(layout, layout.degree());
  laplacian.reset();
  moments = layout.new_vector();
  guess = layout.new_vector();
}

template <int dim>
std::vector<State::Accepted> Predictor<dim>::recent() const
{
  const std::size_t known = std::min<std::size_t>(state.path().size(), order + 1);
  return {state.path().end() - known, state.path().end()};
}

/// States so near each other that their difference is noise are passed over, and so are those at so
/// uneven distances that the polynomial multiplies their errors.
template <int dim>
typename Predictor<dim>::Supports Predictor<dim>::supports(const std::vector<double>& places,
                                                           const double place,
                                                           const Parity parity) const
{
  constexpr double near = 1e-3, multiple = 100.;
  const double newest = places.back();
  // Guesses between two states have to be of one order.
  const double there =
      place > newest || places.size() == 1 ? place : (newest + places[places.size() - 2]) / 2.;
  Supports found{{newest}, {state.path().back()}};
  for (std::size_t k = places.size() - 1; k-- > 0 && found.places.size() <= order;) {
    if (!(found.places.front() - places[k] > near * std::abs(there - newest)))
      continue;
    std::vector<double> next = found.places;
    next.insert(next.begin(), places[k]);
    double sum = 0.;
    for (const double weight : weights(next, there, parity))
      sum += std::abs(weight);
    if (next.size() > 2 && sum > multiple)
      break;
    found.places = std::move(next);
    found.states.insert(found.states.begin(), state.path()[k]);
  }
  return found;
}

/// Whether the guess, at @p load, goes on about as the last step went, by the @p metric or in the
/// displacements alone.
template <int dim>
bool Predictor<dim>::goes_on(const Supports& path, const double load,
                             const PathMetric* metric) const
{
  constexpr double apart = 1.2; // of unit vectors: 74 degrees
  const auto length = [&](const Displacement& u, const double l) {
    return metric ? metric->length(u, l) : u.l2_norm();
  };
  const State::Accepted &last = path.states.back(), &before = path.states[path.states.size() - 2];
  Displacement step = last.x.block(0), change = guess.block(0);
  step -= before.x.block(0);
  change -= last.x.block(0);
  const double step_load = last.load - before.load, change_load = load - last.load,
               ratio = length(step, step_load) / length(change, change_load);
  change.sadd(ratio, -1., step);
  return length(change, ratio * change_load - step_load) < apart * length(step, step_load);
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
    if (path.states.size() <= 2 || place <= path.places.back() || goes_on(path, load, metric))
      return load;
    path.places.erase(path.places.begin());
    path.states.erase(path.states.begin());
  }
}

template <int dim>
void Predictor<dim>::predict(const double load, const LoadSymmetry symmetry)
{
  std::vector<double> loads;
  loads.reserve(state.path().size());
  for (const State::Accepted& accepted : state.path())
    loads.push_back(accepted.load);
  const Parity parity = symmetry == LoadSymmetry::voltage ? Parity::even : Parity::none;
  extrapolate(supports(loads, load, parity), load, parity, nullptr);
}

template <int dim>
double Predictor<dim>::predict_along(const std::vector<double>& places, const double place,
                                     const PathMetric& metric)
{
  return extrapolate(supports(places, place, Parity::none), place, Parity::none, &metric);
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
    follow_rotation(path, even);
  state.x.update_ghost_values();
  follow_cells(path, even);
  guess = state.x;
}

template <int dim>
void Predictor<dim>::follow_rotation(const std::vector<State::Accepted>& path,
                                     const std::vector<double>& weights)
{
  constexpr double negligible = 1e-5; // root mean square of the effect
  std::vector<std::vector<double>> x(path.size());
  std::vector<Tensor3<2>> F(path.size());
  std::vector<double> values, size{0., 0.}, sum(2);
  moments = 0.;
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    for (std::size_t k = 0; k < path.size(); ++k)
      layout.gather(cell, path[k].x, x[k]);
    values.assign(cell.dofs.size(), 0.);
    for (unsigned int q = 0; q < reduced->basis().n_points; ++q) {
      const auto& point = reduced->of_cell(index)[q];
      const Gradients<dim> gradients(reduced->basis(), q, point);
      for (std::size_t k = 0; k < path.size(); ++k)
        F[k] = point_state(CellView<dim>{index, cell, x[k].data(), nullptr, state.theta,
                                         layout.has(Field::temperature)},
                           gradients)
                   .F;
      const Tensor3<2> H = rotation_effect(F, weights);
      size[0] += point.JxW * H.norm_square();
      size[1] += point.JxW;
      for (unsigned int a = 0; a < gradients.n_nodes; ++a)
        for (int i = 0; i < dim; ++i)
          for (int J = 0; J < dim; ++J)
            values[a * cell.n_components + i] +=
                point.JxW * H[axis<dim>(i)][axis<dim>(J)] * gradients.g[J][a];
    }
    layout.scatter(cell, values, moments);
  }
  moments.compress(dealii::VectorOperation::add);
  dealii::Utilities::MPI::sum(size, layout.communicator(), sum);
  if (sum[0] < negligible * negligible * sum[1])
    return;
  if (!laplacian)
    make_laplacian();
  conditions.constraints().set_zero(moments);
  laplacian->solve(moments);
  state.x.block(0) += moments.block(0);
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
double Predictor<dim>::surprise() const
{
  if (state.path().size() < 2)
    return 0.; // nothing was foretold
  auto correction = state.x.block(0), step = state.x.block(0);
  correction -= guess.block(0);
  step -= state.path().back().x.block(0);
  const double length = step.l2_norm();
  return length > 0. ? correction.l2_norm() / length : 0.;
}

template <int dim>
void Predictor<dim>::adapt(const double surprise)
{
  constexpr double trusted = 0.3;
  order = surprise > trusted ? 1 : std::min(order + 1, highest_order);
}

template class Predictor<2>;
template class Predictor<3>;

} // namespace thelma
