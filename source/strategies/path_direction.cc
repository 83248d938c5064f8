#include <thelma/base/rotation.h>
#include <thelma/elements/cell_points.h>
#include <thelma/strategies/path_direction.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace thelma
{

bool goes_on(const State::Accepted& before, const State::Accepted& last, const BlockVector& guess,
             const double load, const PathMetric* metric)
{
  using Displacement = PathMetric::Displacement;
  constexpr double apart = 1.4; // of unit vectors: almost a right angle
  const auto length = [&](const Displacement& u, const double l) {
    return metric ? metric->length(u, l) : u.l2_norm();
  };
  Displacement step = last.x.block(0), change = guess.block(0);
  step -= before.x.block(0);
  change -= last.x.block(0);
  const double step_load = last.load - before.load, change_load = load - last.load,
               ratio = length(step, step_load) / length(change, change_load);
  change.sadd(ratio, -1., step);
  return length(change, ratio * change_load - step_load) < apart * length(step, step_load);
}

template <int dim>
bool deforms_on(const DofLayout<dim>& layout, const Integration<dim>& rule,
                const std::array<const BlockVector*, 3>& states, const double ratio)
{
  constexpr double across = 0.02;             // cosine of almost a right angle, as above
  std::vector<double> x, own(3, 0.), sums(3); // products of step and change
  bool sound = true;
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    for (unsigned int q = 0; q < rule.basis().n_points; ++q) {
      const auto& point = rule.of_cell(index)[q];
      Tensor3<2> F[3];
      for (int k = 0; k < 3; ++k) {
        layout.gather(cell, *states[k], x);
        F[k] = deformation_gradient(cell, x.data(), Gradients<dim>(rule.basis(), q, point));
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

template bool deforms_on(const DofLayout<2>&, const Integration<2>&,
                         const std::array<const BlockVector*, 3>&, double);
template bool deforms_on(const DofLayout<3>&, const Integration<3>&,
                         const std::array<const BlockVector*, 3>&, double);

} // namespace thelma
