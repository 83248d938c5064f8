#include <thelma/elements/integrate.h>
#include <thelma/output/observables.h>

#include <deal.II/base/mpi.h>

namespace thelma
{

template <int dim>
double mean_temperature(const Scene<dim>& scene)
{
  if (!scene.layout.has(Field::temperature))
    return scene.state.theta;
  const Integration<dim> rule(scene.layout, scene.layout.degree() + 1);
  std::vector<double> sums{0., 0.}, total(2);
  scene.system.for_each_cell([&](const CellView<dim>& view) {
    for (unsigned int q = 0; q < rule.basis().n_points; ++q) {
      const auto& point = rule.of_cell(view.index)[q];
      sums[0] += point.JxW * point_state(view, Gradients<dim>(rule.basis(), q, point)).theta;
      sums[1] += point.JxW;
    }
  });
  dealii::Utilities::MPI::sum(sums, scene.layout.communicator(), total);
  return total[0] / total[1];
}

template double mean_temperature(const Scene<2>&);
template double mean_temperature(const Scene<3>&);

} // namespace thelma
