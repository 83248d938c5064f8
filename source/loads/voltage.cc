#include <thelma/base/error.h>
#include <thelma/loads/load_list.h>
#include <thelma/loads/prescribed.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// The voltage of the source, which drives electrodes.
template <int dim>
class Voltage final : public Load<dim>
{
public:
  void setup(const LoadInput<dim>& input) override
  {
    layout = &input.layout;
    conditions = input.conditions;
    if (input.loading == nullptr)
      return;
    target = input.loading->target_voltage();
    field = input.loading->field(target);
  }

  bool is_present() const override { return layout->has(Field::potential); }
  SceneEntry entry() const override { return {"Electrodes", "Potential"}; }
  Field acts_on() const override { return Field::potential; }
  AmplitudeEntry amplitude() const override { return {"Voltage", "Multiple of the voltage"}; }
  LevelText text() const override { return {"e = ", "", field}; }

  void check(const Stages& stages, const std::string& name, const std::size_t index) const override
  {
    for (const Stage& stage : stages.list())
      if (!stage.is_ramp())
        check_change(stages, stage);
      else if (stage.load == index && is_present())
        check_ramp(stages, stage, name);
  }

  void prescribe(State& state) const override
  {
    if (!is_present())
      return;
    state.voltage = this->level() * target;
    prescribe_values(conditions->driven(), 0., state.voltage, state.x);
  }

  /// Where nothing is driven, the voltage is that of what carries a charge.
  void observe(State& state) const override
  {
    const std::vector<const Electrode*> live = conditions->live_electrodes();
    if (!live.empty() && live.front()->floats)
      state.voltage = potential(*live.front(), *layout, state.x) / live.front()->voltage_multiple;
  }

private:
  void check_ramp(const Stages& stages, const Stage& stage, const std::string& name) const
  {
    if (target == 0.)
      throw InputError(std::string(Stages::place) + ": '" + name +
                       "' has no target where the Control is charge; write 'charge', or choose "
                       "the Control voltage or e");
    const auto& electrodes = conditions->electrodes();
    const auto answers = [&](const Electrode& electrode) {
      return electrode.voltage_multiple != 0. &&
             (!electrode.floats || stages.change(Stage::Kind::connect, electrode.name));
    };
    if (stage.level != 0. && std::none_of(electrodes.begin(), electrodes.end(), answers))
      throw InputError(entry().place() +
                       ": no electrode gets a part of the voltage; give one a multiple other than "
                       "0, or make all regions passive");
  }

  /// A connected electrode keeps its potential, so that the voltage becomes what it has.
  void check_change(const Stages& stages, const Stage& stage) const
  {
    const std::string place = Stages::place;
    const Electrode& electrode = conditions->electrode(stage.electrode, place);
    if (stage.kind == Stage::Kind::disconnect && electrode.touches)
      throw InputError(place + ": 'disconnect " + stage.electrode +
                       "' has no effect, as it touches another electrode; leave a gap");
    if (stage.kind != Stage::Kind::connect)
      return;
    if (electrode.voltage_multiple == 0.)
      throw InputError(place + ": the ground electrode '" + stage.electrode +
                       "' cannot be connected; connect one whose multiple of the voltage is not 0");
    if (target == 0.)
      throw InputError(place + ": 'connect " + stage.electrode +
                       "' needs a voltage to go on with; choose the Control voltage or e");
    for (const Electrode& other : conditions->electrodes())
      if (other.name != stage.electrode && other.voltage_multiple != 0. && !other.floats &&
          !stages.change(Stage::Kind::disconnect, other.name))
        throw InputError(place + ": 'connect " + stage.electrode +
                         "' makes its potential that of the voltage, and '" + other.name +
                         "' would jump to it; disconnect '" + other.name + "' before");
  }

  const DofLayout<dim>* layout = nullptr;
  const BoundaryConditions<dim>* conditions = nullptr;
  double target = 0., field = 0.; ///< kV, e
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_voltage()
{
  return std::make_unique<Voltage<dim>>();
}

template std::unique_ptr<Load<2>> make_voltage();
template std::unique_ptr<Load<3>> make_voltage();

} // namespace thelma
