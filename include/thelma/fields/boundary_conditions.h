#pragma once

#include <thelma/fields/electrodes.h>

#include <deal.II/lac/affine_constraints.h>

#include <map>
#include <string>
#include <vector>

namespace thelma
{

/// Supports, electrodes and prescribed temperatures of a scene. Newton's corrections obey
/// homogeneous constraints; the prescribed values are written into the iterate beforehand.
template <int dim>
class BoundaryConditions
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Find the degrees of freedom of every named surface. Throws InputError for unknown names, for
  /// a potential without ground, for surfaces in regions that carry no field, or if a body of the
  /// mesh could move without strain.
  void setup(const Mesh<dim>& mesh, const DofLayout<dim>& layout);

  /// Zero corrections at every prescribed degree of freedom.
  const dealii::AffineConstraints<double>& constraints() const { return homogeneous; }

  /// Write the values at supports that do not move into the owned entries of @p x.
  void hold_supports(BlockVector& x) const;

  const std::vector<Electrode>& electrodes() const { return electrode_set.all(); }
  std::vector<const Electrode*> live_electrodes() const { return electrode_set.live(); }
  const Electrode& electrode(const std::string& name, const std::string& place) const
  {
    return electrode_set.named(name, place);
  }

  /// Let the electrode @p name float with @p charge (uC) from now on, or drive it.
  void disconnect(const std::string& name, double charge);
  void connect(const std::string& name);

  /// Displacement unknowns that move, with their way in mm.
  const std::map<dealii::types::global_dof_index, double>& moved() const { return moved_dofs; }

  /// Names of supports, at rest or moved, that hold @p component (from 0).
  std::vector<std::string> holding(unsigned int component) const;

  /// Potential unknowns of driven electrodes, with their multiple of the voltage.
  const std::map<dealii::types::global_dof_index, double>& driven() const { return driven_dofs; }

  /// Temperature unknowns of the walls with their value in K.
  const std::map<dealii::types::global_dof_index, double>& heated() const { return heated_dofs; }

  /// Temperatures of the walls in K by their names.
  const std::map<std::string, double>& walls() const { return temperatures; }

  /// Unconstrained unknowns of @p field over all ranks.
  dealii::types::global_dof_index n_free(const DofLayout<dim>& layout, Field field) const;

private:
  using Values = std::map<dealii::types::global_dof_index, double>;

  static void fix(const Mesh<dim>& mesh, const DofLayout<dim>& layout, const std::string& surface,
                  const std::string& place, unsigned int component, double value, Values& values);
  void fix_supports(const Mesh<dim>& mesh, const DofLayout<dim>& layout);
  void fix_moved_supports(const Mesh<dim>& mesh, const DofLayout<dim>& layout);
  void fix_axis(const DofLayout<dim>& layout);
  void require_held(const Mesh<dim>& mesh) const;
  void collect_driven();
  void fix_temperatures(const Mesh<dim>& mesh, const DofLayout<dim>& layout);

  std::map<std::string, std::string> supports;
  std::map<std::string, std::string> moved_supports;
  std::map<std::string, double> temperatures;
  Electrodes<dim> electrode_set;

  dealii::IndexSet owned;
  Values fixed_dofs;  ///< value in mm
  Values moved_dofs;  ///< value in mm at the end of the way
  Values driven_dofs; ///< multiple of the voltage
  Values heated_dofs; ///< value in K
  dealii::AffineConstraints<double> homogeneous;
};

} // namespace thelma
