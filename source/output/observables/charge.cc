#include <thelma/output/observables/observables.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace thelma
{
namespace
{

/// Charge on the live electrodes (Electrodes::live), that on negative ones with the other sign,
/// from the reactions of the potential (exact for the discrete energy); capacitance: that over the
/// voltage of the curve. In plane strain per mm.
template <int dim>
class Charge final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  std::vector<std::string> columns_of_kind() const override
  {
    return {"charge_uC", "capacitance_nF"};
  }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    const double voltage = scene.state.voltage;
    double charge = 0.;
    for (const Electrode* electrode : scene.conditions.live_electrodes())
      charge -= std::copysign(1., electrode->voltage_multiple) *
                electrode->own_sum(scene.system.reactions());
    charge = dealii::Utilities::MPI::sum(charge, scene.layout.communicator());
    return {charge, voltage != 0. ? charge / voltage : 0.};
  }
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_charge(const ObservableName& name)
{
  return std::make_unique<Charge<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_charge(const ObservableName&);
template std::unique_ptr<Observable<3>> make_charge(const ObservableName&);

} // namespace thelma
