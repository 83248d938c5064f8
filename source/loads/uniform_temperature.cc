#include <thelma/loads/load_list.h>

namespace thelma
{
namespace
{

/// From the reference temperature to Temperature/Value: of the whole body where the temperature is
/// no field, or before time begins. Walls and surroundings start from there; those of a steady
/// field from the reference temperature.
template <int dim>
class UniformTemperature final : public Load<dim>
{
public:
  void setup(const LoadInput<dim>& input) override
  {
    layout = &input.layout;
    start = input.theta_start;
    end = input.theta;
  }

  bool is_present() const override { return true; }
  SceneEntry entry() const override { return {"Temperature", "Value"}; }
  Field acts_on() const override { return Field::temperature; }
  bool has_stage() const override { return false; }
  bool is_heating() const override { return true; }
  AmplitudeEntry amplitude() const override { return {}; }

  void prescribe(State& state) const override
  {
    const double theta = start + this->level() * (end - start);
    if (!layout->has(Field::temperature))
      state.theta = theta;
    state.theta_start = layout->has_transient_temperature() ? theta : start;
    if (layout->has_transient_temperature() && !state.rates)
      state.x.block(layout->block(Field::temperature)) = theta;
  }

private:
  const DofLayout<dim>* layout = nullptr;
  double start = 293., end = 293.; ///< K
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_uniform_temperature()
{
  return std::make_unique<UniformTemperature<dim>>();
}

template std::unique_ptr<Load<2>> make_uniform_temperature();
template std::unique_ptr<Load<3>> make_uniform_temperature();

} // namespace thelma
