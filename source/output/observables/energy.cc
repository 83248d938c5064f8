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
  std::vector<std::string> columns() const override
  {
    return {"energy_elastic_mJ", "energy_electric_mJ"};
  }

  std::vector<double> evaluate(const Scene<dim>& scene) override
  {
    const Energies own = scene.system.energies();
    const std::vector<double> sums{own.elastic, own.electric};
    std::vector<double> total(2);
    dealii::Utilities::MPI::sum(sums, scene.layout.communicator(), total);
    return total;
  }
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_energy()
{
  return std::make_unique<Energy<dim>>();
}

template std::unique_ptr<Observable<2>> make_energy();
template std::unique_ptr<Observable<3>> make_energy();

} // namespace thelma
