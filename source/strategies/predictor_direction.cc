// Whether a guess goes on where the last step went.

#include <thelma/base/rotation.h>
#include <thelma/elements/integrate.h>
#include <thelma/strategies/predictor.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace thelma
{

/// Whether the guess, at @p load, goes on about as the last step went, by the @p metric or in the
/// displacements alone.
template <int dim>
bool Predictor<dim>::goes_on(const Supports& path, const double load,
                             const PathMetric* metric) const
{
  constexpr double apart = 1.4; // of unit vectors: almost a right angle
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

/// The rotation vector of @p R that comes nearest to @p expected, by more than half a turn if need
/// be.
Tensor3<1> rotation_near(const Tensor3<2>& R, const Tensor3<1>& expected)
{
  const Tensor3<1> turn = rotation_vector(R);
  const double angle = turn.norm();
  if (angle == 0.)
    return turn;
  const double whole = 2. * dealii::numbers::PI;
  return turn + std::round((expected - turn) * turn / (angle * whole)) * whole / angle * turn;
}

/// The same of rotations and stretches: the displacements of a body that rolls up turn back as it
/// goes on.
template <int dim>
bool Predictor<dim>::deforms_on(const Supports& path, const double place) const
{
  const std::vector<double>& places = path.places;
  const double ratio =
      (place - places.back()) / (places.back() - places[places.size() - 2]); // of the steps
  constexpr double across = 0.02; // cosine of almost a right angle, as above
  const BlockVector* const states[] = {&path.states[path.states.size() - 2].x,
                                       &path.states.back().x, &guess};
  std::vector<double> x, own(3, 0.), sums(3); // products of step and change
  bool sound = true;
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    for (unsigned int q = 0; q < reduced->basis().n_points; ++q) {
      const auto& point = reduced->of_cell(index)[q];
      Tensor3<2> F[3];
      for (int k = 0; k < 3; ++k) {
        layout.gather(cell, *states[k], x);
        F[k] = point_state(CellView<dim>{index, cell, x.data(), nullptr, state.theta,
                                         layout.has(Field::temperature)},
                           Gradients<dim>(reduced->basis(), q, point))
                   .F;
      }
      sound = sound && dealii::determinant(F[2]) > 0.;
      if (!sound)
        break;
      const PolarDecomposition before(F[0]), last(F[1]), next(F[2]);
      const Tensor3<1> turn = rotation_vector(last.R * dealii::transpose(before.R)),
                       new_turn = rotation_near(next.R * dealii::transpose(last.R), ratio * turn);
      const Tensor3<2> stretch = last.U - before.U, new_stretch = next.U - last.U;
      own[0] += point.JxW * (turn * turn + stretch.norm_square());
      own[1] += point.JxW * (new_turn * new_turn + new_stretch.norm_square());
      own[2] += point.JxW * (turn * new_turn + dealii::scalar_product(stretch, new_stretch));
    }
  }
  dealii::Utilities::MPI::sum(own, layout.communicator(), sums);
  return dealii::Utilities::MPI::min(sound ? 1 : 0, layout.communicator()) == 1 &&
         sums[2] > across * std::sqrt(sums[0] * sums[1]);
}

#define INSTANTIATE(dim)                                                                           \
  template bool Predictor<dim>::goes_on(const Supports&, double, const PathMetric*) const;         \
  template bool Predictor<dim>::deforms_on(const Supports&, double) const;
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
