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
  void setup(const Scene<dim>& scene) override { points.setup(scene); }

  std::vector<std::string> columns() const override { return {"max_det_F"}; }

  std::vector<double> evaluate(const Scene<dim>& scene) override
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
std::unique_ptr<Observable<dim>> make_det_F()
{
  return std::make_unique<DetF<dim>>();
}

template std::unique_ptr<Observable<2>> make_det_F();
template std::unique_ptr<Observable<3>> make_det_F();

} // namespace thelma
