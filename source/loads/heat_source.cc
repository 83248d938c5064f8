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

/// Heat sources of regions, per volume of the undeformed body.
template <int dim>
class HeatSource final : public HeatLoad<dim>
{
public:
  void declare(dealii::ParameterHandler& prm) override
  {
    const Section section(prm, {"Heat"});
    add_distributions(prm, "Source", sources,
                      "Heat source R of regions, per undeformed volume, as `film: 0.5`", 1,
                      "mW/mm^3");
  }

  void setup(const LoadInput<dim>& input) override
  {
    HeatLoad<dim>::setup(input);
    this->require_field(entry(), is_present());
    if (!is_present())
      return;
    mesh = &input.mesh;
    for (const auto& source : sources)
      require_region(*mesh, source.first, entry().place());
    powers.setup(entry(), *this->layout, change_in_time(sources),
                 [this](const double time, BlockVector& nodal) { integrate(time, nodal); });
  }

  bool is_present() const override { return !sources.empty(); }
  SceneEntry entry() const override { return {"Heat", "Source"}; }
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
    add_integrals<dim>(*this->layout, nodal_rule<dim>(*this->layout), Field::temperature,
                       densities_at(time, sources, *mesh), nodal);
  }

  Distributions<dim> sources; ///< mW/mm^3
  const Mesh<dim>* mesh = nullptr;
  NodalForces<dim> powers; ///< mW
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_heat_source()
{
  return std::make_unique<HeatSource<dim>>();
}

template std::unique_ptr<Load<2>> make_heat_source();
template std::unique_ptr<Load<3>> make_heat_source();

} // namespace thelma
