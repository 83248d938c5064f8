#include <thelma/base/distribution.h>
#include <thelma/base/parameters.h>
#include <thelma/fields/nodal_quadrature.h>
#include <thelma/loads/heat_load.h>
#include <thelma/loads/load_list.h>
#include <thelma/loads/nodal_forces.h>

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
    prm.add_parameter(
        "Source", texts,
        "Heat source R of regions, per undeformed volume, as `film: 0.5`. " +
            std::string(Distribution<dim>::sentence) + ". Unit: mW/mm^3.",
        dealii::Patterns::Map(dealii::Patterns::Anything(), dealii::Patterns::Anything(), 0, 100));
    check_values(prm, "Source",
                 [](const std::string& text) { Distribution<dim>(text, 1, "mW/mm^3"); });
  }

  void setup(const LoadInput<dim>& input) override
  {
    HeatLoad<dim>::setup(input);
    this->require_field(entry(), is_present());
    if (!is_present())
      return;
    mesh = &input.mesh;
    bool in_time = false;
    sources.clear();
    for (const auto& [name, text] : texts) {
      require_region(*mesh, name, entry().place());
      const Distribution<dim>& given =
          sources.emplace(name, Distribution<dim>(text, 1, "mW/mm^3")).first->second;
      in_time = in_time || given.changes_in_time();
    }
    powers.setup(entry(), *this->layout, in_time,
                 [this](const double time, BlockVector& nodal) { integrate(time, nodal); });
  }

  bool is_present() const override { return !texts.empty(); }
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
    add_nodal_integrals<dim>(
        *this->layout, Field::temperature,
        [&](const Cell<dim>& cell, const dealii::Point<dim>& X) {
          const auto found = sources.find(mesh->region_of(cell.iterator));
          return found == sources.end() ? 0. : found->second(0, X, time);
        },
        nodal);
  }

  std::map<std::string, std::string> texts;
  std::map<std::string, Distribution<dim>> sources; ///< mW/mm^3
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
