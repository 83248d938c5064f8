#include <thelma/output/points.h>

#include <deal.II/base/mpi.h>

namespace thelma
{
namespace
{

/// Volume of the deformed over that of the undeformed body.
template <int dim>
class Volume final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void setup(const ObservableInput<dim>& scene) override { points.setup(scene); }

  std::vector<std::string> columns_of_kind() const override { return {"volume_ratio"}; }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    double deformed = 0., undeformed = 0.;
    points.visit(scene, [&](const PointState<>& state, const Material&, const double JxW) {
      deformed += JxW * Kinematics<>(state.F).J;
      undeformed += JxW;
    });
    const MPI_Comm comm = scene.layout.communicator();
    return {dealii::Utilities::MPI::sum(deformed, comm) /
            dealii::Utilities::MPI::sum(undeformed, comm)};
  }

private:
  Points<dim> points;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_volume(const ObservableName& name)
{
  return std::make_unique<Volume<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_volume(const ObservableName&);
template std::unique_ptr<Observable<3>> make_volume(const ObservableName&);

} // namespace thelma
