#include <thelma/output/observables/observables.h>

#include <deal.II/base/mpi.h>

namespace thelma
{
namespace
{

/// Stored elastic and electric energy, as the element formulation integrates them: of the
/// functional whose stationary point the state is; and that of dead forces. In plane strain per mm.
template <int dim>
class Energy final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void setup(const ObservableInput<dim>& scene) override
  {
    dead.clear();
    for (std::size_t i = 0; i < scene.loads.size(); ++i)
      if (scene.loads[i].is_present() && scene.loads[i].is_dead())
        dead.push_back(i);
  }

  std::vector<std::string> columns_of_kind() const override
  {
    std::vector<std::string> columns{"energy_elastic_mJ", "energy_electric_mJ"};
    if (!dead.empty())
      columns.emplace_back("energy_loads_mJ");
    return columns;
  }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    const Energies own = scene.system.cells.energies();
    const std::vector<double> sums{own.elastic, own.electric};
    std::vector<double> total(2);
    dealii::Utilities::MPI::sum(sums, scene.layout.communicator(), total);
    if (!dead.empty())
      total.push_back(potential(scene));
    return total;
  }

private:
  /// Eq. (69).
  double potential(const ObservableInput<dim>& scene) const
  {
    const State& state = scene.state;
    BlockVector forces = scene.layout.new_vector();
    for (const std::size_t i : dead)
      scene.loads[i].add_forces(-1., {scene.loads[i].level(), state.time}, state, state.x, forces);
    forces.compress(dealii::VectorOperation::add);
    const unsigned int u = scene.layout.block(Field::displacement);
    return forces.block(u) * state.x.block(u);
  }

  std::vector<std::size_t> dead; ///< loads with this energy
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
