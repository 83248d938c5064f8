#include <thelma/output/points.h>

#include <deal.II/base/mpi.h>

namespace thelma
{

template <int dim>
double mean_temperature(const ObservableInput<dim>& scene)
{
  if (!scene.layout.has(Field::temperature))
    return scene.state.theta;
  Points<dim> points;
  points.setup(scene);
  std::vector<double> sums{0., 0.}, total(2);
  points.visit(scene, [&](const PointState<>& state, const Material&, const double JxW) {
    sums[0] += JxW * state.theta;
    sums[1] += JxW;
  });
  dealii::Utilities::MPI::sum(sums, scene.layout.communicator(), total);
  return total[0] / total[1];
}

template double mean_temperature(const ObservableInput<2>&);
template double mean_temperature(const ObservableInput<3>&);

} // namespace thelma
