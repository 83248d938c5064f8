#include <thelma/loads/heat_load.h>
#include <thelma/loads/load_list.h>
#include <thelma/loads/prescribed.h>

namespace thelma
{
namespace
{

/// Surfaces of given temperature, on their way from where the body starts.
template <int dim>
class WallTemperature final : public HeatLoad<dim>
{
public:
  void setup(const LoadInput<dim>& input) override
  {
    HeatLoad<dim>::setup(input);
    conditions = input.conditions;
    theta = input.theta;
  }

  bool is_present() const override
  {
    return conditions != nullptr && !conditions->heated().empty();
  }
  SceneEntry entry() const override { return {"Temperature", "Fixed"}; }
  AmplitudeEntry amplitude() const override { return wall_amplitude; }

  void check_level(const double time, const double level) const override
  {
    for (const auto& [unknown, wall] : conditions->heated())
      check_wall_temperature(theta, wall, time, level);
  }

  void prescribe(State& state) const override
  {
    prescribe_values(conditions->heated(), state.theta_start, this->level(), state.x);
  }

private:
  const BoundaryConditions<dim>* conditions = nullptr;
  double theta = 293.; ///< K, at time 0
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_wall_temperature()
{
  return std::make_unique<WallTemperature<dim>>();
}

template std::unique_ptr<Load<2>> make_wall_temperature();
template std::unique_ptr<Load<3>> make_wall_temperature();

} // namespace thelma
