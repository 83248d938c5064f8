#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/fields/nodal_quadrature.h>
#include <thelma/loads/heat_load.h>
#include <thelma/loads/load_list.h>

#include <map>

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
    add_quantity(prm, "Flux", fluxes,
                 "Heat flux into the body through surfaces, per area of the undeformed surface, as "
                 "`outer: 0.5`.",
                 Quantity("mW/mm^2"));
  }

  void setup(const LoadInput<dim>& input) override
  {
    HeatLoad<dim>::setup(input);
    this->require_field(entry(), is_present());
    if (!is_present())
      return;
    powers = this->layout->new_vector();
    for (const auto& [name, flux] : fluxes)
      for_each_nodal_area(input.mesh, *this->layout, name, entry().place(), Field::temperature,
                          "heat can flow only through these",
                          [this, flux = flux](const auto unknown, const double area) {
                            powers(unknown) += area * flux;
                          });
    powers.compress(dealii::VectorOperation::add);
  }

  bool is_present() const override { return !fluxes.empty(); }
  SceneEntry entry() const override { return {"Heat", "Flux"}; }
  AmplitudeEntry amplitude() const override { return heat_amplitude; }
  bool acts_at_once() const override { return false; }

  void add_forces(const double factor, const double level, const State& /*state*/,
                  const BlockVector& /*x*/, BlockVector& nodal) const override
  {
    nodal.add(factor * level, powers);
  }

private:
  std::map<std::string, double> fluxes; ///< mW/mm^2
  BlockVector powers;                   ///< mW
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
