#include <thelma/base/error.h>
#include <thelma/loads/load_list.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// The charge of floating electrodes.
template <int dim>
class Charge final : public Load<dim>
{
public:
  void setup(const LoadInput<dim>& input) override
  {
    has_potential = input.layout.has(Field::potential);
    conditions = input.conditions;
    if (input.loading != nullptr)
      target = input.loading->target_charge();
  }

  bool is_present() const override { return has_potential; }
  SceneEntry entry() const override { return {"Electrodes", "Floating"}; }
  Field acts_on() const override { return Field::potential; }
  AmplitudeEntry amplitude() const override
  {
    return {"Charge", "Multiple of the charge of floating electrodes"};
  }
  LevelText text() const override { return {"", " uC", target}; }

  void check(const Stages& stages, const std::string& /*name*/,
             const std::size_t index) const override
  {
    const auto& electrodes = conditions->electrodes();
    const bool answers =
        std::any_of(electrodes.begin(), electrodes.end(),
                    [](const Electrode& electrode) { return electrode.charge_multiple != 0.; });
    for (const Stage& stage : stages.list())
      if (stage.is_ramp() && stage.load == index && is_present() && stage.level != 0. && !answers)
        throw InputError(entry().place() +
                         ": no electrode gets a part of the charge; write `NAME: 1`");
  }

  void prescribe(State& state) const override { state.charge = this->level() * target; }

private:
  const BoundaryConditions<dim>* conditions = nullptr;
  bool has_potential = false;
  double target = 0.; ///< uC
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_charge()
{
  return std::make_unique<Charge<dim>>();
}

template std::unique_ptr<Load<2>> make_charge();
template std::unique_ptr<Load<3>> make_charge();

} // namespace thelma
