#pragma once

#include <thelma/base/distribution.h>
#include <thelma/fields/nodal_quadrature.h>
#include <thelma/loads/load.h>

#include <functional>
#include <string>

namespace thelma
{

/// The densities of the regions of the @p mesh at a time, times a @p factor.
template <int dim>
std::function<Density<dim>(const Cell<dim>&)>
densities_at(double time, const Distributions<dim>& densities, const Mesh<dim>& mesh,
             double factor = 1.);

/// Nodal forces that do not depend on the iterate: integrated once or, where they change in time,
/// whenever it has moved on.
template <int dim>
class NodalForces
{
public:
  /// Adds the forces at the time (s); compress(add) comes later.
  using Integrate = std::function<void(double time, BlockVector&)>;

  /// Those of the @p entry. Throws InputError if they change @p in_time and the scene has none, and
  /// if they are not finite.
  void setup(const SceneEntry& entry, const DofLayout<dim>& layout, bool in_time,
             Integrate integrate);

  /// Add @p factor times the forces at the @p time.
  void add(double factor, double time, BlockVector& nodal) const;

private:
  void integrate_at(double time) const;

  std::string place;
  bool in_time = false;
  Integrate integrate;
  mutable double last = 0.; ///< time in s
  mutable BlockVector forces;
};

} // namespace thelma
