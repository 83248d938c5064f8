#pragma once

#include <thelma/fields/dof_layout.h>
#include <thelma/fields/rates.h>

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace thelma
{

/// What enters a body through its walls and from its sources, but for what the nodes of walls of
/// prescribed temperature store themselves: that has no rate where a wall jumps.
struct HeatInflow {
  double heat = 0.;    ///< mW
  double entropy = 0.; ///< the same over the temperature where it enters, mW/K

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& heat& entropy;
  }
};

/// The iterate, the load it belongs to, and the accepted states behind it.
class State
{
public:
  /// An accepted state.
  struct Accepted {
    double load;
    BlockVector x;
    std::vector<double> internal;
    std::vector<double> history = {}; ///< what laws remember at the points of the own cells
  };

  /// So many of the newest accepted states know what laws remember: those a step needs.
  static constexpr std::size_t n_remembering = 2;

  /// From now on @p update tells what laws remember after a step to the iterate. They only remember
  /// accepted states: what Newton's method tries leaves nothing behind.
  void remember_by(std::function<std::vector<double>()> update) { remember = std::move(update); }

  /// What laws remember after a step to the iterate; empty where none does.
  std::vector<double> history() const { return remember ? remember() : std::vector<double>(); }

  /// Begin a path at @p load with the iterate as its accepted start.
  void start(double load = 0.);

  /// Stand at the end of a @p path that has been accepted before.
  void resume(std::vector<Accepted> path);

  /// Remember the iterate as the converged state at the load factor @p load.
  void accept(double load);

  /// Make the @p accepted state the iterate.
  void go_to(const Accepted& accepted);

  /// Return to the last accepted state.
  void restore() { go_to(past.back()); }

  /// Forget the last accepted state and return to the one before it.
  void forget();

  /// Changes whenever accepted states come or go.
  std::size_t version() const { return n_changes; }

  /// Load factor of the last accepted state.
  double accepted_load() const { return past.back().load; }

  /// The load at which the path through the last three accepted states turns back, from the
  /// parabola load^2(arc length of displacements); infinity while the load does not slow down.
  double estimated_limit() const;

  /// Load factor that those three states cover.
  double recent_span() const
  {
    return past.back().load - past[past.size() < 3 ? 0 : past.size() - 3].load;
  }

  /// The last accepted states (at most `memory`), the newest last.
  const std::vector<Accepted>& path() const { return past; }

  /// All but the accepted states.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    bool has_rates = rates.has_value();
    archive& voltage& charge& theta& theta_start& time& inflow& unstable_directions& has_rates;
    if (!has_rates)
      rates.reset();
    else if (!rates)
      rates.emplace();
    if (has_rates)
      archive&* rates;
  }

  BlockVector x;                ///< values of all fields, with ghosts
  std::vector<double> internal; ///< unknowns inside the own cells, such as element pressures
  double voltage = 0.;          ///< kV
  double charge = 0.;           ///< applied to floating electrodes, uC
  double theta = 0.;            ///< uniform temperature in K
  double theta_start = 0.;      ///< from which walls and surroundings start, K
  double time = 0.;             ///< s; in transient scenes also the load
  HeatInflow inflow;            ///< into the accepted state

  /// Of the newest recorded state.
  long long unstable_directions = 0;

  /// How rates follow from the iterate and the accepted states; none in a steady state.
  std::optional<Rates> rates;

  /// Whether internal variables remain those of the body at rest where there are no rates;
  /// otherwise they have relaxed.
  bool holds_without_time = false;

private:
  /// The iterate, once it is accepted.
  Accepted accepted(double load) const;

  static constexpr std::size_t memory = 4;
  std::vector<Accepted> past;
  std::size_t n_changes = 1;
  std::function<std::vector<double>()> remember; ///< none where no law remembers
};

/// A temperature of a cell in K, where one number has to do for all of it: that at its last node.
template <int dim>
double cell_temperature(const DofLayout<dim>& layout, const State& state, const Cell<dim>& cell)
{
  if (!layout.has(Field::temperature))
    return state.theta;
  return state.x.block(layout.block(Field::temperature))
      .local_element(
          cell.local[cell.unknown(cell.local.size() / cell.n_components - 1, Field::temperature)]);
}

} // namespace thelma
