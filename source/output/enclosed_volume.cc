#include <thelma/fields/deformed_surface.h>
#include <thelma/output/observables.h>

#include <deal.II/base/mpi.h>

namespace thelma
{
namespace
{

/// Volume between a named surface and the symmetry planes through the origin, of a balloon's inside
/// for example (theory.md, eq. 58). In plane strain per mm.
template <int dim>
class EnclosedVolume final : public Observable<dim>
{
public:
  void declare(dealii::ParameterHandler& prm) override
  {
    prm.add_parameter("Of", name,
                      "Surface that encloses the volume, alone or with symmetry planes through the "
                      "origin; in plane strain per mm of depth.");
  }

  void setup(const Scene<dim>& scene) override
  {
    surface.setup(scene.mesh, scene.layout, name,
                  "section Observables/enclosed_volume, entry 'Of'");
    at_rest = signed_volume(scene.layout, scene.layout.new_vector());
  }

  std::vector<std::string> columns() const override { return {"enclosed_volume_mm3"}; }

  std::vector<double> evaluate(const Scene<dim>& scene) override
  {
    const double now = signed_volume(scene.layout, scene.state.x);
    return {at_rest < 0. ? -now : now};
  }

private:
  double signed_volume(const FieldLayout<dim>& layout, const BlockVector& x) const
  {
    return dealii::Utilities::MPI::sum(surface.own_volume(layout, x), layout.communicator());
  }

  std::string name;
  DeformedSurface<dim> surface;
  double at_rest = 0.;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_enclosed_volume()
{
  return std::make_unique<EnclosedVolume<dim>>();
}

template std::unique_ptr<Observable<2>> make_enclosed_volume();
template std::unique_ptr<Observable<3>> make_enclosed_volume();

} // namespace thelma
