#pragma once

#include <thelma/loads/load.h>

#include <vector>

namespace thelma
{

/// The heat that the nodes store: the capacity by the quadrature whose points are the nodes
/// (theory.md, eq. 37). So it has no entries beside the diagonal, and small time steps cause no
/// undershoots.
template <int dim>
class HeatStorage
{
public:
  void setup(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions);

  /// Add the heat that is stored at the nodes, in mW.
  void add_residual(const State& state, BlockVector& residual) const;
  void add_tangent(const State& state, TangentEntries<dim>& tangent) const;

  /// Heat flow that changes every temperature by 1 K in one time step, over all nodes (norm, mW).
  double storage_scale(const State& state) const;

  /// Minus what the nodes of walls store: it flows in through them.
  HeatInflow wall_inflow(const State& state) const;

  /// Energy c (theta - theta_0) in mJ and entropy c ln(theta/theta_0) in mJ/K of the own nodes.
  Energies stored(const State& state, double theta_0) const;

  /// The same of the own nodes of prescribed temperature.
  Energies stored_in_walls(const State& state, double theta_0) const;

  /// Heat capacity of each node in mJ/K, in the block of the temperature.
  const BlockVector& capacity() const { return capacities; }

private:
  double storage(const State& state, unsigned int i) const;
  void add_stored(const State& state, double theta_0, unsigned int i, Energies& sum) const;

  unsigned int block = 0;
  BlockVector capacities;          ///< mJ/K
  std::vector<unsigned int> walls; ///< local numbers of the own nodes
  bool exists = false;
};

} // namespace thelma
