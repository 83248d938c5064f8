#include <thelma/base/distribution.h>
#include <thelma/base/parameters.h>
#include <thelma/fields/nodal_quadrature.h>
#include <thelma/loads/heat_load.h>
#include <thelma/loads/load_list.h>
#include <thelma/loads/nodal_forces.h>

namespace thelma
{
namespace
{

/// Heat flux through surfaces, per area of the undeformed surface.
template <int dim>
class SurfaceHeatFlux final : public HeatLoad<dim>
{
public:
  void declare(dealii::ParameterHandler& prm) override
  {
    const Section section(prm, {"Heat"});
    add_distributions(prm, "Flux", fluxes,
                      "Heat flux into the body through surfaces, per area of the undeformed "
                      "surface, as `outer: 0.5`",
                      1, "mW/mm^2");
  }

  void setup(const LoadInput<dim>& input) override
  {
    HeatLoad<dim>::setup(input);
    this->require_field(entry(), is_present());
    if (!is_present())
      return;
    mesh = &input.mesh;
    powers.setup(entry(), *this->layout, change_in_time(fluxes),
                 [this](const double time, BlockVector& nodal) { integrate(time, nodal); });
  }

  bool is_present() const override { return !fluxes.empty(); }
  SceneEntry entry() const override { return {"Heat", "Flux"}; }
  AmplitudeEntry amplitude() const override { return heat_amplitude; }
  bool acts_at_once() const override { return false; }

  void add_forces(const double factor, const Instant& at, const State& /*state*/,
                  const BlockVector& /*x*/, BlockVector& nodal) const override
  {
    powers.add(factor * at.level, at.time, nodal);
  }

private:
  void integrate(const double time, BlockVector& nodal) const
  {
    for (const auto& [name, flux] : fluxes)
      for_each_nodal_area(*mesh, *this->layout, name, entry().place(), Field::temperature,
                          "heat can flow only through these",
                          [&, &flux = flux](const auto unknown, const double area, const auto& X) {
                            nodal(unknown) += area * flux(0, X, time);
                          });
  }

  Distributions<dim> fluxes; ///< mW/mm^2
  const Mesh<dim>* mesh = nullptr;
  NodalForces<dim> powers; ///< mW
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_heat_flux()
{
  return std::make_unique<SurfaceHeatFlux<dim>>();
}

template std::unique_ptr<Load<2>> make_heat_flux();
template std::unique_ptr<Load<3>> make_heat_flux();

} // namespace thelma
