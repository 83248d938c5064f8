// In how many directions a state is unstable.

#include <thelma/assembly/system.h>

#include <cmath>

namespace thelma
{

template <int dim>
bool System<dim>::knows_stability() const
{
  return solver && (solver->has_inertia() || (symmetric_part && symmetric_part->knows_stability()));
}

/// A steady temperature answers to the deformation. Where the sign of the determinant of the whole
/// tangent says that this changes the count, it does so in the direction that is nearest to it.
template <int dim>
LinearReport System<dim>::count_pivots(const long long own)
{
  LinearReport report{true, "", false, own};
  if (!symmetric_part)
    return report;
  const long long parity = own + unstable_inside;
  symmetric_part->stabilisations = stabilisations;
  symmetric_part->assemble_tangent();
  const auto timer = timings.measure("factorisation");
  report = symmetric_part->prepare_solver();
  unstable_inside = symmetric_part->unstable_inside;
  const bool agrees = (report.negative_pivots + unstable_inside - parity) % 2 == 0;
  if (!report.solved || layout.has_transient_temperature() || agrees)
    return report;
  BlockVector mode;
  const double nearest = symmetric_part->critical_mode(mode);
  if (!std::isnan(nearest))
    report.negative_pivots += nearest > 0. ? 1 : -1;
  return report;
}

template <int dim>
long long System<dim>::unstable_directions(const long long negative_pivots) const
{
  const long long expected =
      layout.has(Field::potential)
          ? static_cast<long long>(conditions.n_free(layout, Field::potential))
          : 0;
  const long long n_floating = floating.charges(0.).size();
  return negative_pivots + unstable_inside - expected - n_floating;
}

template bool System<2>::knows_stability() const;
template bool System<3>::knows_stability() const;
template LinearReport System<2>::count_pivots(long long);
template LinearReport System<3>::count_pivots(long long);
template long long System<2>::unstable_directions(long long) const;
template long long System<3>::unstable_directions(long long) const;

} // namespace thelma
