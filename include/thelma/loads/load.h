#pragma once

#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/state.h>
#include <thelma/loads/loading.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace thelma
{

/// Where the loads add their part of a tangent.
template <int dim>
class TangentEntries
{
public:
  virtual ~TangentEntries() = default;

  /// Add the tangent of the own cell @p index, row by row in the order of Cell::dofs.
  virtual void add(std::size_t index, const Cell<dim>& cell,
                   const std::vector<double>& entries) = 0;

  /// Add @p value to the diagonal of an own unknown; nothing where it has no equation.
  virtual void add_diagonal(dealii::types::global_dof_index unknown, double value) = 0;
};

/// What loads are set up from.
template <int dim>
struct LoadInput {
  const Mesh<dim>& mesh;
  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>* conditions; ///< null where they could not be set up
  const Loading* loading;                    ///< null where it could not be set up
  double theta_start, theta;                 ///< reference temperature, Temperature/Value in K
};

/// How much of a load acts and when.
struct Instant {
  double level, time; ///< a multiple of what the scene gives; s
};

/// How a level of a load is written: `before`, the level times `size`, `after`.
struct LevelText {
  std::string before, after;
  double size = 1.;

  /// "between e = 0.1 and 0.2".
  std::string between(double low, double high) const;
};

/// The entry `<name> amplitude` of the section Time, if there is one, and what it gives.
struct AmplitudeEntry {
  std::string name, meaning;
};

/// An entry of the scene.
struct SceneEntry {
  std::string section, name;
  std::string place() const { return "section " + section + ", entry '" + name + "'"; }
  std::string path() const { return section + "/" + name; }
};

/// Something that acts on the body. How much of it acts is its level, a multiple of what the scene
/// gives. A new load is one file and one line in load_list.cc.
template <int dim>
class Load
{
public:
  virtual ~Load() = default;
  virtual void declare(dealii::ParameterHandler&) {}

  /// Throws InputError for what the scene cannot have.
  virtual void setup(const LoadInput<dim>& input) = 0;

  /// Whether the scene has it.
  virtual bool is_present() const = 0;

  /// The entry of the scene that gives it.
  virtual SceneEntry entry() const = 0;

  /// The field in whose balance it acts.
  virtual Field acts_on() const = 0;

  /// Whether stages drive it; and whether the heating before them does. Other loads act in time
  /// alone.
  virtual bool has_stage() const { return true; }
  virtual bool is_heating() const { return false; }

  /// Whether a jump of it changes the body however soon one looks.
  virtual bool acts_at_once() const { return true; }

  /// Whether it consists of forces that do not depend on the displacement, so that minus their work
  /// is an energy.
  virtual bool is_dead() const { return false; }

  /// What gives its level over time. Loads may share an entry.
  virtual AmplitudeEntry amplitude() const = 0;
  virtual LevelText text() const { return {}; }

  /// Throws InputError where the @p stages, which know it by its @p name and @p index, do not fit.
  virtual void check(const Stages& stages, const std::string& name, std::size_t index) const;

  /// Throws InputError for a @p level that it cannot have at the @p time (s).
  virtual void check_level(double /*time*/, double /*level*/) const {}

  /// Write what its level prescribes into the iterate.
  virtual void prescribe(State&) const {}

  /// Write into a converged state what this tells of the load.
  virtual void observe(State&) const {}

  /// Add @p factor times its nodal forces (N, minus uC, mW) @p at an instant and the nodal values
  /// @p x to @p nodal, whose compress(add) comes later.
  virtual void add_forces(double /*factor*/, const Instant& /*at*/, const State& /*state*/,
                          const BlockVector& /*x*/, BlockVector& /*nodal*/) const
  {
  }

  /// Add minus the derivative of its forces by the iterate.
  virtual void add_tangent(const State&, TangentEntries<dim>&) const {}

  /// Work in mJ per level of a load that prescribes values, given the reactions; this rank's part.
  virtual double work_per_level(const BlockVector& /*reactions*/) const { return 0.; }

  double level() const { return now; }
  void set_level(const double level) { now = level; }

private:
  double now = 0.;
};

} // namespace thelma
