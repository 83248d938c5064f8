#pragma once

#include <thelma/assembly/cell_loop.h>
#include <thelma/assembly/floating_electrodes.h>
#include <thelma/assembly/heat_storage.h>
#include <thelma/solvers/newton.h>

#include <vector>

namespace thelma
{

/// The size of a residual, each field in units of its own: the norms of the nodal forces that a
/// unit stress mu (displacement sqrt(eps mu), heat flux k * 1 K/mm) exerts (theory.md, "Residual
/// norms").
template <int dim>
class ResidualNorm
{
public:
  ResidualNorm(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
               const HeatStorage<dim>& storage)
      : layout(layout), conditions(conditions), storage(storage)
  {
  }

  /// Compute the units at the state's temperature.
  void setup(const CellLoop<dim>& cells, const State& state);

  /// Include the equations inside the cells, whose squared residual on this rank is @p squares; the
  /// nodal ones; and the charges of floating electrodes.
  void include_internal(double squares, ResidualReport& report) const;
  void include_nodal(const BlockVector& residual, const State& state, ResidualReport& report) const;
  void include_charges(const FloatingElectrodes<dim>& floating, const BlockVector& reactions,
                       const State& state, ResidualReport& report) const;

private:
  double unit(unsigned int block, const State& state) const;

  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  const HeatStorage<dim>& storage;
  std::vector<double> units;        ///< per block
  std::vector<double> charge_units; ///< of all electrodes
  double volume = 0.;               ///< mm^dim
};

} // namespace thelma
