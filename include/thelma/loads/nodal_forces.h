#pragma once

#include <thelma/loads/load.h>

#include <functional>
#include <string>

namespace thelma
{

/// Throws InputError, with the @p place in the sentence, where no region of the @p mesh has the
/// @p name.
template <int dim>
void require_region(const Mesh<dim>& mesh, const std::string& name, const std::string& place);

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
