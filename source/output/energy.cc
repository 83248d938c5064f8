#include <thelma/elements/integrate.h>
#include <thelma/output/observables.h>

#include <deal.II/base/mpi.h>

#include <optional>

namespace thelma
{
namespace
{

/// Stored elastic and electric energy, by the full Gauss rule. In plane strain per mm.
template <int dim>
class Energy final : public Observable<dim>
{
public:
  void setup(const Scene<dim>& scene) override
  {
    rule.emplace(scene.layout, scene.layout.degree() + 1);
  }

  std::vector<std::string> columns() const override
  {
    return {"energy_elastic_mJ", "energy_electric_mJ"};
  }

  std::vector<double> evaluate(const Scene<dim>& scene) override
  {
    std::vector<double> sums{0., 0.};
    scene.system.for_each_cell([&](const CellView<dim>& view) {
      for (unsigned int q = 0; q < rule->basis().n_points; ++q) {
        const auto& point = rule->of_cell(view.index)[q];
        const Energies energies = view.cell.material->energies(
            point_state(view, Gradients<dim>(rule->basis(), q, point)));
        sums[0] += point.JxW * energies.elastic;
        sums[1] += point.JxW * energies.electric;
      }
    });
    std::vector<double> total(2);
    dealii::Utilities::MPI::sum(sums, scene.layout.communicator(), total);
    return total;
  }

private:
  std::optional<Integration<dim>> rule;
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
