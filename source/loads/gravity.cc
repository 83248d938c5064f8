#include <thelma/base/distribution.h>
#include <thelma/base/error.h>
#include <thelma/base/parameters.h>
#include <thelma/fields/nodal_quadrature.h>
#include <thelma/loads/load_list.h>
#include <thelma/loads/nodal_forces.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <optional>

namespace thelma
{
namespace
{

/// The weight of the body under an acceleration of fixed direction: a body force rho_0 g per
/// undeformed volume.
template <int dim>
class Gravity final : public Load<dim>
{
public:
  void declare(dealii::ParameterHandler& prm) override
  {
    const Section section(prm, {"Loads"});
    prm.declare_entry("Gravity", "", dealii::Patterns::Anything(),
                      "Components of the acceleration in multiples of g = 9.80665 m/s^2, as `" +
                          std::string(dim == 3 ? "0 " : "") +
                          "0 -1`, to which the stage `gravity` (Loading/Stages) goes. " +
                          Distribution<dim>::sentence +
                          ". Weights follow from Materials/.../Density. Empty: none.");
    prm.add_action("Gravity", [this](const std::string& text) {
      multiples.reset();
      if (!text.empty())
        multiples.emplace(text, dim, "1");
      is_axial = dealii::Utilities::trim(text).rfind("0 ", 0) == 0;
    });
  }

  void setup(const LoadInput<dim>& input) override
  {
    layout = &input.layout;
    if (is_present() && layout->is_axisymmetric() && !is_axial)
      throw InputError(entry().place() + ": a body of revolution stays one under gravity along its "
                                         "axis alone; write `0 -1`, or a scene in space");
    if (is_present())
      forces.setup(entry(), *layout, multiples->changes_in_time(),
                   [this](const double time, BlockVector& nodal) { integrate(time, nodal); });
  }

  bool is_present() const override { return multiples.has_value(); }
  SceneEntry entry() const override { return {"Loads", "Gravity"}; }
  Field acts_on() const override { return Field::displacement; }
  bool is_dead() const override { return true; }
  AmplitudeEntry amplitude() const override { return {"Gravity", "Multiple of the gravity"}; }
  LevelText text() const override { return {"", " times the gravity"}; }

  void add_forces(const double factor, const Instant& at, const State& /*state*/,
                  const BlockVector& /*x*/, BlockVector& nodal) const override
  {
    forces.add(factor * at.level, at.time, nodal);
  }

private:
  void integrate(const double time, BlockVector& nodal) const
  {
    constexpr double unit = 9.80665 * 1e-9; // of one kg/m^3 in N/mm^3
    const auto weight_of = [&](const Cell<dim>& cell) -> Density<dim> {
      return [&, weight = unit * cell.material->density](const unsigned int c,
                                                         const dealii::Point<dim>& X) {
        return weight * (*multiples)(c, X, time);
      };
    };
    add_integrals<dim>(*layout, dealii::QGauss<dim>(layout->degree() + 1), Field::displacement,
                       weight_of, nodal);
  }

  std::optional<Distribution<dim>> multiples; ///< of g
  bool is_axial = false;                      ///< in the plane: along x3
  const DofLayout<dim>* layout = nullptr;
  NodalForces<dim> forces;
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_gravity()
{
  return std::make_unique<Gravity<dim>>();
}

template std::unique_ptr<Load<2>> make_gravity();
template std::unique_ptr<Load<3>> make_gravity();

} // namespace thelma
