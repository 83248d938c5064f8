#pragma once

#include <thelma/assembly/tangent_matrix.h>
#include <thelma/fields/state.h>

#include <functional>
#include <map>
#include <string>

namespace thelma
{

/// What the heat balance has at the nodes: the capacity, given heat fluxes, convection and sources,
/// all by the quadrature whose points are the nodes (theory.md, eq. 33). So the capacity has no
/// entries beside the diagonal, and small time steps cause no undershoots.
template <int dim>
class NodalHeat
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Throws InputError for unknown names, or if nothing holds a steady temperature.
  void setup(const Mesh<dim>& mesh, const FieldLayout<dim>& layout,
             const BoundaryConditions<dim>& conditions);

  /// Fluxes and sources at the multiple @p power of their value, the surroundings at the fraction
  /// @p warming of their way from @p theta_start (K).
  void apply(double theta_start, double warming, double power);

  /// Add the heat that is stored at the nodes less what enters, in mW.
  void add_residual(const State& state, BlockVector& residual) const;
  void add_tangent(const State& state, TangentMatrix<dim>& tangent) const;

  /// Heat flow that changes every temperature by 1 K in one time step, over all nodes (norm, mW).
  double storage_scale(const State& state) const;

  /// What flows through surfaces with a flux or convection, and from sources, less what the nodes
  /// of walls store.
  HeatInflow inflow(const State& state) const;

  /// Energy c (theta - theta_0) in mJ and entropy c ln(theta/theta_0) in mJ/K of the own nodes.
  Energies stored(const State& state, double theta_0) const;

  /// The same of the own nodes of prescribed temperature.
  Energies stored_in_walls(const State& state, double theta_0) const;

  /// Heat capacity of each node in mJ/K, in the block of the temperature.
  const BlockVector& capacity() const { return capacities; }

  /// Temperature in K around each surface with convection.
  const std::map<std::string, double>& ambient_temperatures() const { return surroundings; }

private:
  struct Surface {
    double flux = 0., convection = 0., ambient = 0.;
  };

  void lump(const FieldLayout<dim>& layout, const std::function<double(const Cell<dim>&)>& density,
            BlockVector& nodal) const;
  void collect_sources(const Mesh<dim>& mesh, const FieldLayout<dim>& layout);
  void collect_surface(const Mesh<dim>& mesh, const FieldLayout<dim>& layout,
                       const std::string& name, const Surface& surface);
  Surface properties(const std::string& name) const;
  double given(const State& state, unsigned int i) const;
  double storage(const State& state, unsigned int i) const;
  void add_stored(const State& state, double theta_0, unsigned int i, Energies& sum) const;

  std::map<std::string, double> fluxes, convections, surroundings, sources;

  unsigned int block = 0;
  BlockVector capacities, powers, conductances, ambient; ///< mJ/K, mW, mW/K, K mW/K
  std::vector<unsigned int> walls;                       ///< local numbers of the own nodes
  double start = 0., warming = 1., power = 1.;
  bool exists = false;
};

} // namespace thelma
