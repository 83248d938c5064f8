#include <thelma/base/quantity.h>
#include <thelma/output/points.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// Largest electric field in the deformed body, F^-T E, and its ratio to what the material stands.
template <int dim>
class Breakdown final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void declare(dealii::ParameterHandler& prm) override
  {
    add_quantity(prm, "Breakdown field", breakdown,
                 "True electric field at which the material breaks down. For acrylic of deformed "
                 "thickness h (mm) and in-plane stretch lambda it is 51 h^-0.25 lambda^0.63 (Huang "
                 "et al. 2012, doi:10.1063/1.4754549); the default is that of 1 mm, not stretched.",
                 Quantity("kV/mm", 1e-12));
  }

  void setup(const ObservableInput<dim>& scene) override { points.setup(scene); }

  std::vector<std::string> columns_of_kind() const override
  {
    return {"max_true_field_kV_mm", "breakdown_ratio"};
  }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    double largest = 0.;
    points.visit(scene, [&](const PointState<>& state, const Material&, double) {
      largest = std::max(largest, (Kinematics<>(state.F).G * state.E).norm());
    });
    largest = dealii::Utilities::MPI::max(largest, scene.layout.communicator());
    return {largest, largest / breakdown};
  }

private:
  double breakdown = 51.; ///< kV/mm
  Points<dim> points;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_breakdown(const ObservableName& name)
{
  return std::make_unique<Breakdown<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_breakdown(const ObservableName&);
template std::unique_ptr<Observable<3>> make_breakdown(const ObservableName&);

} // namespace thelma
