#include <thelma/output/points.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// Largest det F; the smallest stands in every curve.
template <int dim>
class DetF final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void setup(const ObservableInput<dim>& scene) override { points.setup(scene); }

  std::vector<std::string> columns_of_kind() const override { return {"max_det_F"}; }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    double largest = 0.;
    points.visit(scene, [&](const PointState<>& state, const Material&, double) {
      largest = std::max(largest, Kinematics<>(state.F).J);
    });
    return {dealii::Utilities::MPI::max(largest, scene.layout.communicator())};
  }

private:
  Points<dim> points;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_det_F(const ObservableName& name)
{
  return std::make_unique<DetF<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_det_F(const ObservableName&);
template std::unique_ptr<Observable<3>> make_det_F(const ObservableName&);

} // namespace thelma
