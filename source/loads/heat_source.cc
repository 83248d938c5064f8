#include <thelma/base/error.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/fields/nodal_quadrature.h>
#include <thelma/loads/heat_load.h>
#include <thelma/loads/load_list.h>

#include <algorithm>
#include <map>

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
    add_quantity(prm, "Source", sources, "Heat source R of regions.", Quantity("mW/mm^3"));
  }

  void setup(const LoadInput<dim>& input) override
  {
    HeatLoad<dim>::setup(input);
    this->require_field(entry(), is_present());
    if (!is_present())
      return;
    const auto& regions = input.mesh.regions();
    for (const auto& [name, source] : sources)
      if (std::find(regions.begin(), regions.end(), name) == regions.end())
        throw InputError(entry().place() + ": the mesh has no region '" + name + "'" +
                         did_you_mean(name, regions));
    powers = this->layout->new_vector();
    add_nodal_integrals<dim>(
        *this->layout, Field::temperature,
        [&](const Cell<dim>& cell) {
          const auto found = sources.find(input.mesh.region_of(cell.iterator));
          return found == sources.end() ? 0. : found->second;
        },
        powers);
    powers.compress(dealii::VectorOperation::add);
  }

  bool is_present() const override { return !sources.empty(); }
  SceneEntry entry() const override { return {"Heat", "Source"}; }
  AmplitudeEntry amplitude() const override { return heat_amplitude; }
  bool acts_at_once() const override { return false; }

  void add_forces(const double factor, const double level, const State& /*state*/,
                  const BlockVector& /*x*/, BlockVector& nodal) const override
  {
    nodal.add(factor * level, powers);
  }

private:
  std::map<std::string, double> sources; ///< mW/mm^3
  BlockVector powers;                    ///< mW
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
