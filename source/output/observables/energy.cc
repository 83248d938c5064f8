#include <thelma/output/observables/observables.h>

#include <deal.II/base/mpi.h>

namespace thelma
{
namespace
{

/// Stored elastic and electric energy, as the element formulation integrates them: of the
/// functional whose stationary point the state is. In plane strain per mm.
template <int dim>
class Energy final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  std::vector<std::string> columns_of_kind() const override
  {
    return {"energy_elastic_mJ", "energy_electric_mJ"};
  }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    const Energies own = scene.system.cells.energies();
    const std::vector<double> sums{own.elastic, own.electric};
    std::vector<double> total(2);
    dealii::Utilities::MPI::sum(sums, scene.layout.communicator(), total);
    return total;
  }
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_energy(const ObservableName& name)
{
  return std::make_unique<Energy<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_energy(const ObservableName&);
template std::unique_ptr<Observable<3>> make_energy(const ObservableName&);

} // namespace thelma
