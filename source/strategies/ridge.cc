#include <thelma/strategies/ridge.h>

namespace thelma
{
namespace
{

/// Lets the load of a system be a force along a direction, beside the loads that it has.
template <int dim>
class Hold final : public LoadPath
{
public:
  Hold(DiscreteSystem<dim>& system, const BlockVector& direction)
      : system(system), direction(direction), before(system.load_along(this))
  {
    system.set_load(0.);
  }
  ~Hold() override
  {
    go_to(0.);
    system.load_along(before);
  }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

  void go_to(const double force) override
  {
    BlockVector forces = direction;
    forces *= force;
    system.hold_with(forces);
  }

private:
  DiscreteSystem<dim>& system;
  const BlockVector& direction;
  LoadPath* before;
};

/// Whether the body, held at the iterate by a force across the @p plane, has more than @p most
/// unstable directions. The iterate itself is not in balance, which stiff directions may show as
/// instability: only if that is corrected and it remains, there is one.
template <int dim>
bool is_unstable_held(DiscreteSystem<dim>& system, const Plane& plane, const long long most,
                      NewtonReport& report)
{
  constexpr int most_corrections = 1;
  BorderedSystem bordered(system, plane);
  for (int k = 0; k <= most_corrections && bordered.residual().admissible(); ++k) {
    LinearReport tangent = bordered.linear_solve(false);
    if (tangent.solved)
      tangent = system.stability.count_pivots(tangent.negative_pivots);
    report.add({0, 1, tangent.iterations});
    if (!tangent.solved)
      return true;
    if (system.stability.unstable_directions(tangent.negative_pivots) <= most)
      return false;
    bordered.move_to(1.);
  }
  return true;
}

} // namespace

template <int dim>
bool is_beyond_ridge(DiscreteSystem<dim>& system, State& state, Predictor<dim>& predictor,
                     const long long most, NewtonReport& report)
{
  const State::Accepted found{state.accepted_load(), state.x, state.internal};
  BlockVector way = found.x;
  way = 0.;
  way.block(0) = found.x.block(0);
  way.block(0) -= state.path().back().x.block(0);
  predictor.between(found, 1. / 3.);
  for (unsigned int b = 1; b < state.x.n_blocks(); ++b)
    state.x.block(b) = found.x.block(b); // at the new load
  state.x.update_ghost_values();
  system.converge_internal();
  way.zero_out_ghost_values();
  way /= way.block(0).l2_norm();
  const Hold<dim> hold(system, way);
  Plane plane;
  plane.normal = way.block(0);
  plane.value = plane.excess(system);
  const bool has_ridge = is_unstable_held(system, plane, most, report);
  state.go_to(found);
  return has_ridge;
}

template bool is_beyond_ridge(DiscreteSystem<2>&, State&, Predictor<2>&, long long, NewtonReport&);
template bool is_beyond_ridge(DiscreteSystem<3>&, State&, Predictor<3>&, long long, NewtonReport&);

} // namespace thelma
