#include <thelma/base/error.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/fields/nodal_quadrature.h>
#include <thelma/loads/heat_load.h>
#include <thelma/loads/load_list.h>

#include <map>
#include <utility>

namespace thelma
{
namespace
{

/// Heat exchange of surfaces with their surroundings, whose temperature is on its way from where
/// the body starts.
template <int dim>
class Convection final : public HeatLoad<dim>
{
public:
  void declare(dealii::ParameterHandler& prm) override
  {
    const Section section(prm, {"Heat"});
    add_quantity(
        prm, "Convection", coefficients,
        "Coefficient h of the heat loss h (theta - theta_inf) of surfaces, as `outer: 0.02`.",
        Quantity("mW/(mm^2 K)", 0.));
    add_quantity(prm, "Surroundings", surroundings,
                 "Temperature theta_inf around the surfaces with convection.",
                 Quantity("K", 1., 1e4));
  }

  void setup(const LoadInput<dim>& input) override
  {
    HeatLoad<dim>::setup(input);
    theta = input.theta;
    this->require_field(entry(), is_present());
    this->require_field({"Heat", "Surroundings"}, !surroundings.empty());
    if (this->layout->has(Field::temperature) && !this->layout->has_transient_temperature() &&
        !is_present() && input.conditions != nullptr && input.conditions->heated().empty())
      throw InputError("section Temperature, entry 'Fixed': a steady temperature field needs a "
                       "surface of known temperature or with convection");
    check_pairs();
    if (!is_present())
      return;
    conductances = ambient = this->layout->new_vector();
    for (const auto& [name, coefficient] : coefficients)
      for_each_nodal_area(input.mesh, *this->layout, name, entry().place(), Field::temperature,
                          "heat can flow only through these",
                          [&, name = name, h = coefficient](const auto unknown, const double area,
                                                            const auto& /*X*/) {
                            conductances(unknown) += area * h;
                            ambient(unknown) += area * h * surroundings.at(name);
                          });
    conductances.compress(dealii::VectorOperation::add);
    ambient.compress(dealii::VectorOperation::add);
  }

  bool is_present() const override { return !coefficients.empty(); }
  SceneEntry entry() const override { return {"Heat", "Convection"}; }
  AmplitudeEntry amplitude() const override { return wall_amplitude; }

  void check_level(const double time, const double level) const override
  {
    for (const auto& [name, temperature] : surroundings)
      check_wall_temperature(theta, temperature, time, level);
  }

  void add_forces(const double factor, const Instant& at, const State& state, const BlockVector& x,
                  BlockVector& nodal) const override
  {
    const unsigned int b = this->layout->block(Field::temperature);
    const auto &G = conductances.block(b), &A = ambient.block(b), &now = x.block(b);
    for (unsigned int i = 0; i < G.locally_owned_size(); ++i)
      nodal.block(b).local_element(i) +=
          factor *
          (at.level * A.local_element(i) -
           G.local_element(i) * (now.local_element(i) - (1. - at.level) * state.theta_start));
  }

  void add_tangent(const State& /*state*/, TangentEntries<dim>& tangent) const override
  {
    const unsigned int b = this->layout->block(Field::temperature);
    const auto begin = conductances.get_block_indices().block_start(b);
    for (const auto i : conductances.block(b).locally_owned_elements())
      tangent.add_diagonal(begin + i, conductances.block(b)(i));
  }

private:
  /// Throws InputError for a surface that has only one of both.
  void check_pairs() const
  {
    for (const auto& [here, there, missing] :
         {std::tuple(&coefficients, &surroundings, "Surroundings"),
          std::tuple(&surroundings, &coefficients, "Convection")})
      for (const auto& [name, value] : *here)
        if (there->count(name) == 0)
          throw InputError(
              "section Heat, entry '" +
              std::string(here == &coefficients ? "Convection" : "Surroundings") + "': surface '" +
              name +
              "' needs a coefficient and a temperature around it; write the other one into "
              "section Heat, entry '" +
              missing + "'");
  }

  std::map<std::string, double> coefficients, surroundings; ///< mW/(mm^2 K), K
  double theta = 293.;                                      ///< K, at time 0
  BlockVector conductances, ambient;                        ///< mW/K, mW
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_convection()
{
  return std::make_unique<Convection<dim>>();
}

template std::unique_ptr<Load<2>> make_convection();
template std::unique_ptr<Load<3>> make_convection();

} // namespace thelma
