#pragma once

#include <thelma/fields/dof_layout.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace thelma
{

/// A surface of one potential: a given one, or that which its charge takes.
struct Electrode {
  std::string name;
  std::vector<dealii::types::global_dof_index> dofs; ///< of all ranks, and of no other electrode
  double voltage_multiple = 0.;                      ///< of the applied voltage, while it is driven
  double charge_multiple = 0.;                       ///< of the applied charge, while it floats
  double kept_charge = 0.;                           ///< uC beside that
  bool floats = false;
  bool touches = false; ///< another one, which is driven alike

  /// Sum of the entries of @p x that this rank owns; of the reactions it is minus the charge.
  double own_sum(const BlockVector& x) const;
};

/// The electrodes of a scene, which may change between driven and floating during a run.
template <int dim>
class Electrodes
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Find the unknowns of every electrode. Throws InputError for unknown names, a potential without
  /// ground, electrodes that touch, or surfaces in regions that carry no field.
  void setup(const Mesh<dim>& mesh, const DofLayout<dim>& layout);

  const std::vector<Electrode>& all() const { return list; }

  /// The electrode called @p name. Throws InputError, with @p place in the sentence.
  const Electrode& named(const std::string& name, const std::string& place) const;

  /// The electrodes on one side of the source, of which the columns of voltage and charge tell:
  /// those that a positive multiple of the voltage drives, or else a negative one; where all of
  /// them float, those with a charge of their own.
  std::vector<const Electrode*> live() const;

  /// Let @p name float with @p charge (uC) from now on, or drive it.
  void disconnect(const std::string& name, double charge);
  void connect(const std::string& name);

private:
  Electrode& find(const std::string& name);
  void add(const Mesh<dim>& mesh, const DofLayout<dim>& layout, Electrode electrode,
           const std::string& place);

  std::map<std::string, double> driven, floating;
  std::vector<Electrode> list;
};

/// Potential of @p electrode in kV.
template <int dim>
double potential(const Electrode& electrode, const DofLayout<dim>& layout, const BlockVector& x);

/// Smallest distance in mm between nodes of two @p electrodes of one body that differ by the whole
/// applied voltage; 0 if there are no such two. To be called by every rank.
template <int dim>
double electrode_distance(const Mesh<dim>& mesh, const std::vector<Electrode>& electrodes);

} // namespace thelma
