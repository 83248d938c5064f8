#include <thelma/fields/deformed_surface.h>
#include <thelma/output/observables/observables.h>

#include <deal.II/base/mpi.h>

namespace thelma
{
namespace
{

/// Volume between a named surface and the symmetry planes through the origin, of a balloon's inside
/// for example (theory.md, eq. 74). In plane strain per mm.
template <int dim>
class EnclosedVolume final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void declare(dealii::ParameterHandler& prm) override
  {
    prm.add_parameter("Of", enclosing,
                      "Surface that encloses the volume, alone or with symmetry planes through the "
                      "origin; in plane strain per mm of depth.");
  }

  void setup(const ObservableInput<dim>& scene) override
  {
    surface.setup(scene.mesh, scene.layout, enclosing, this->name.place("Of"));
    at_rest = signed_volume(scene.layout, scene.layout.new_vector());
  }

  std::vector<std::string> columns_of_kind() const override { return {"enclosed_volume_mm3"}; }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    const double now = signed_volume(scene.layout, scene.state.x);
    return {at_rest < 0. ? -now : now};
  }

private:
  double signed_volume(const DofLayout<dim>& layout, const BlockVector& x) const
  {
    return dealii::Utilities::MPI::sum(surface.own_volume(layout, x), layout.communicator());
  }

  std::string enclosing;
  DeformedSurface<dim> surface;
  double at_rest = 0.;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_enclosed_volume(const ObservableName& name)
{
  return std::make_unique<EnclosedVolume<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_enclosed_volume(const ObservableName&);
template std::unique_ptr<Observable<3>> make_enclosed_volume(const ObservableName&);

} // namespace thelma
