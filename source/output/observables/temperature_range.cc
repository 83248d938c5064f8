#include <thelma/output/observables/observables.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// Lowest and highest temperature of all nodes.
template <int dim>
class TemperatureRange final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  std::vector<std::string> columns_of_kind() const override
  {
    return {"theta_min_K", "theta_max_K"};
  }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    if (!scene.layout.has(Field::temperature))
      return {scene.state.theta, scene.state.theta};
    const auto& theta = scene.state.x.block(scene.layout.block(Field::temperature));
    const double* begin = theta.begin();
    const auto [low, high] = std::minmax_element(begin, begin + theta.locally_owned_size());
    const bool has_own = theta.locally_owned_size() > 0;
    const MPI_Comm comm = scene.layout.communicator();
    return {dealii::Utilities::MPI::min(has_own ? *low : 1e300, comm),
            dealii::Utilities::MPI::max(has_own ? *high : 0., comm)};
  }
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_temperature_range(const ObservableName& name)
{
  return std::make_unique<TemperatureRange<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_temperature_range(const ObservableName&);
template std::unique_ptr<Observable<3>> make_temperature_range(const ObservableName&);

} // namespace thelma
