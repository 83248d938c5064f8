#pragma once

#include <thelma/assembly/discrete_system.h>
#include <thelma/base/named_list.h>
#include <thelma/output/observables/observable_name.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// What an observable may look at.
template <int dim>
struct ObservableInput {
  const MaterialLibrary& materials;
  const Mesh<dim>& mesh;
  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  const Loads<dim>& loads;
  const HeatStorage<dim>& storage;
  const DiscreteSystem<dim>& system;
  const State& state;
};

/// Volume mean of the temperature in K.
template <int dim>
double mean_temperature(const ObservableInput<dim>& scene);

/// One or a few named numbers per accepted step. A new kind is one file and one line in
/// observable_list.cc; the parameters of an observable stand in the section Observables/<its name>.
template <int dim>
class Observable
{
public:
  explicit Observable(ObservableName name) : name(std::move(name)) {}
  virtual ~Observable() = default;
  virtual void declare(dealii::ParameterHandler&) {}
  virtual void setup(const ObservableInput<dim>&) {}

  /// Column names with their unit, such as `charge_uC`.
  std::vector<std::string> columns() const
  {
    std::vector<std::string> names;
    for (const std::string& column : columns_of_kind())
      names.push_back(name.column(column));
    return names;
  }

  /// What a reader of the columns must know of this scene, a sentence to a line.
  virtual std::vector<std::string> remarks() const { return {}; }

  /// In the present state. What depends on earlier steps too (`ledger`) is asked once per accepted
  /// step, in order.
  virtual std::vector<double> evaluate(const ObservableInput<dim>& scene) = 0;

  /// All that evaluate() remembers of earlier steps, for a checkpoint; restore() takes it back.
  virtual std::vector<double> saved() const { return {}; }
  virtual void restore(const std::vector<double>&) {}

  const ObservableName name;

protected:
  /// Those of one that has the name of its kind.
  virtual std::vector<std::string> columns_of_kind() const = 0;
};

/// The kinds.
template <int dim>
const NamedList<Observable<dim>, ObservableName>& observables();

template <int dim>
std::unique_ptr<Observable<dim>> make_charge(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_electrodes(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_energy(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_rotation(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_displacement(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_stretch(const ObservableName& name, unsigned int direction);
template <int dim>
std::unique_ptr<Observable<dim>> make_reaction(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_volume(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_enclosed_volume(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_det_F(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_breakdown(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_ledger(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_probe(const ObservableName& name);
template <int dim>
std::unique_ptr<Observable<dim>> make_temperature_range(const ObservableName& name);

} // namespace thelma
