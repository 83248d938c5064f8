#pragma once

#include <thelma/assembly/system.h>
#include <thelma/base/named_list.h>

#include <memory>
#include <string>
#include <vector>

namespace thelma
{

/// What an observable may look at.
template <int dim>
struct Scene {
  const MaterialLibrary& materials;
  const Mesh<dim>& mesh;
  const FieldLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  const Loads<dim>& loads;
  const HeatStorage<dim>& storage;
  const System<dim>& system;
  const State& state;
};

/// Volume mean of the temperature in K.
template <int dim>
double mean_temperature(const Scene<dim>& scene);

/// One or a few named numbers per accepted step. A new observable is one file and one line in
/// observable_list.cc; its parameters stand in the section Observables/<its name>.
template <int dim>
class Observable
{
public:
  virtual ~Observable() = default;
  virtual void declare(dealii::ParameterHandler&) {}
  virtual void setup(const Scene<dim>&) {}

  /// Column names with their unit, such as `charge_uC`.
  virtual std::vector<std::string> columns() const = 0;

  /// What a reader of the columns must know of this scene, a sentence to a line.
  virtual std::vector<std::string> remarks() const { return {}; }

  /// In the present state. What depends on earlier steps too (`ledger`) is asked once per accepted
  /// step, in order.
  virtual std::vector<double> evaluate(const Scene<dim>& scene) = 0;

  /// All that evaluate() remembers of earlier steps, for a checkpoint, and back.
  virtual std::vector<double> memory() const { return {}; }
  virtual void remember(const std::vector<double>&) {}
};

template <int dim>
const NamedList<Observable<dim>>& observables();

template <int dim>
std::unique_ptr<Observable<dim>> make_charge();
template <int dim>
std::unique_ptr<Observable<dim>> make_electrodes();
template <int dim>
std::unique_ptr<Observable<dim>> make_energy();
template <int dim>
std::unique_ptr<Observable<dim>> make_rotation(const std::string& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_displacement(const std::string& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_stretch(unsigned int direction);
template <int dim>
std::unique_ptr<Observable<dim>> make_reaction();
template <int dim>
std::unique_ptr<Observable<dim>> make_volume();
template <int dim>
std::unique_ptr<Observable<dim>> make_enclosed_volume();
template <int dim>
std::unique_ptr<Observable<dim>> make_det_F();
template <int dim>
std::unique_ptr<Observable<dim>> make_breakdown();
template <int dim>
std::unique_ptr<Observable<dim>> make_ledger();
template <int dim>
std::unique_ptr<Observable<dim>> make_probe();
template <int dim>
std::unique_ptr<Observable<dim>> make_temperature_range();

} // namespace thelma
