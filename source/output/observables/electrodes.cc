#include <thelma/output/observables/observables.h>

#include <deal.II/base/mpi.h>

namespace thelma
{
namespace
{

/// Potential, charge and capacitance of every electrode, driven or floating. In plane strain per
/// mm.
template <int dim>
class ElectrodeStates final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void setup(const ObservableInput<dim>& scene) override
  {
    for (const Electrode& electrode : scene.conditions.electrodes())
      for (const std::string quantity : {"_voltage_kV", "_charge_uC", "_capacitance_nF"})
        names.push_back(electrode.name + quantity);
  }

  std::vector<std::string> columns_of_kind() const override { return names; }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    std::vector<double> values;
    for (const Electrode& electrode : scene.conditions.electrodes()) {
      const double V = potential(electrode, scene.layout, scene.state.x);
      const double Q = -dealii::Utilities::MPI::sum(electrode.own_sum(scene.system.reactions()),
                                                    scene.layout.communicator());
      values.insert(values.end(), {V, Q, V != 0. ? Q / V : 0.});
    }
    return values;
  }

private:
  std::vector<std::string> names;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_electrodes(const ObservableName& name)
{
  return std::make_unique<ElectrodeStates<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_electrodes(const ObservableName&);
template std::unique_ptr<Observable<3>> make_electrodes(const ObservableName&);

} // namespace thelma
