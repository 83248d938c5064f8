#include <thelma/output/points.h>

#include <deal.II/base/mpi.h>

namespace thelma
{
namespace
{

/// Stored elastic and electric energy, by the full Gauss rule. In plane strain per mm.
template <int dim>
class Energy final : public Observable<dim>
{
public:
  void setup(const Scene<dim>& scene) override { points.setup(scene); }

  std::vector<std::string> columns() const override
  {
    return {"energy_elastic_mJ", "energy_electric_mJ"};
  }

  std::vector<double> evaluate(const Scene<dim>& scene) override
  {
    std::vector<double> sums{0., 0.};
    points.visit(scene, [&](const PointState<>& state, const Material& material, const double JxW) {
      const Energies energies = material.energies(state);
      sums[0] += JxW * energies.elastic;
      sums[1] += JxW * energies.electric;
    });
    std::vector<double> total(2);
    dealii::Utilities::MPI::sum(sums, scene.layout.communicator(), total);
    return total;
  }

private:
  Points<dim> points;
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
