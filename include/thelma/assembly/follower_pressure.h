#pragma once

#include <thelma/assembly/tangent_matrix.h>
#include <thelma/fields/deformed_surface.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>

namespace thelma
{

/// Pressures that act on surfaces of the deformed body and follow it (theory.md, eqs. 49 to 51).
template <int dim>
class FollowerPressure
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Throws InputError for unknown surfaces and for those with an edge along which the pressure
  /// would have no potential.
  void setup(const Mesh<dim>& mesh, const FieldLayout<dim>& layout,
             const BoundaryConditions<dim>& conditions);

  bool exist() const { return !surfaces.empty(); }

  /// From now on they act with this multiple of their values.
  void apply(const double multiple) { factor = multiple; }
  double level() const { return factor; }

  /// Add @p scale times their nodal forces in N (in plane strain N per mm) at @p x to @p nodal,
  /// whose compress(add) comes later.
  void add_forces(const double scale, const BlockVector& x, BlockVector& nodal) const
  {
    add_full_forces(scale * factor, x, nodal);
  }

  /// The same at level 1.
  void add_full_forces(double scale, const BlockVector& x, BlockVector& nodal) const;

  void add_tangent(const BlockVector& x, TangentMatrix<dim>& tangent) const;

private:
  struct Loaded {
    double pressure; ///< MPa
    DeformedSurface<dim> surface;
  };

  std::map<std::string, double> values;
  const FieldLayout<dim>* layout = nullptr;
  std::vector<Loaded> surfaces;
  double factor = 0.;
};

} // namespace thelma
