#include <thelma/output/observables.h>

#include <deal.II/base/mpi.h>

namespace thelma
{
namespace
{

/// Charge that the voltage has moved onto the driven electrodes, from the reactions of the
/// potential (exact for the discrete energy), and capacitance Q / V. In plane strain per mm.
template <int dim>
class Charge final : public Observable<dim>
{
public:
  std::vector<std::string> columns() const override { return {"charge_uC", "capacitance_nF"}; }

  std::vector<double> evaluate(const Scene<dim>& scene) override
  {
    const auto owned = scene.layout.dof_handler().locally_owned_dofs();
    double charge = 0.;
    for (const auto& [dof, factor] : scene.conditions.driven())
      if (owned.is_element(dof))
        charge -= factor * scene.system.reactions()(dof);
    charge = dealii::Utilities::MPI::sum(charge, scene.layout.communicator());
    const double voltage = scene.state.voltage;
    return {charge, voltage > 0. ? charge / voltage : 0.};
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
