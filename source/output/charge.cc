#include <thelma/output/observables.h>

#include <deal.II/base/mpi.h>

namespace thelma
{
namespace
{

/// Charge q that the voltage V has moved onto the electrodes, such that V dq is their work: each
/// electrode's charge counts by its part of the voltage, which a floating one has found itself.
/// From the reactions of the potential (exact for the discrete energy); capacitance q/V. In plane
/// strain per mm.
template <int dim>
class Charge final : public Observable<dim>
{
public:
  std::vector<std::string> columns() const override { return {"charge_uC", "capacitance_nF"}; }

  std::vector<double> evaluate(const Scene<dim>& scene) override
  {
    const double voltage = scene.state.voltage;
    double charge = 0.;
    for (const Electrode& electrode : scene.conditions.electrodes()) {
      double part = electrode.voltage_multiple;
      if (electrode.floats)
        part = voltage != 0. ? potential(electrode, scene.layout, scene.state.x) / voltage : 0.;
      charge -= part * electrode.own_sum(scene.system.reactions());
    }
    charge = dealii::Utilities::MPI::sum(charge, scene.layout.communicator());
    return {charge, voltage != 0. ? charge / voltage : 0.};
  }
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_charge()
{
  return std::make_unique<Charge<dim>>();
}

template std::unique_ptr<Observable<2>> make_charge();
template std::unique_ptr<Observable<3>> make_charge();

} // namespace thelma
