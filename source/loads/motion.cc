#include <thelma/loads/load_list.h>
#include <thelma/loads/prescribed.h>

namespace thelma
{
namespace
{

/// Supports that move.
template <int dim>
class Motion final : public Load<dim>
{
public:
  void setup(const LoadInput<dim>& input) override { conditions = input.conditions; }

  bool is_present() const override { return conditions != nullptr && !conditions->moved().empty(); }
  SceneEntry entry() const override { return {"Supports", "Moved"}; }
  Field acts_on() const override { return Field::displacement; }
  AmplitudeEntry amplitude() const override
  {
    return {"Motion", "Part of the way of the moved supports"};
  }
  LevelText text() const override { return {"", " of the way of the moved supports"}; }

  void prescribe(State& state) const override
  {
    prescribe_values(conditions->moved(), 0., this->level(), state.x);
  }

  double work_per_level(const BlockVector& reactions) const override
  {
    const dealii::IndexSet owned = reactions.locally_owned_elements();
    double work = 0.;
    for (const auto& [unknown, way] : conditions->moved())
      if (owned.is_element(unknown))
        work += way * reactions(unknown);
    return work;
  }

private:
  const BoundaryConditions<dim>* conditions = nullptr;
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_motion()
{
  return std::make_unique<Motion<dim>>();
}

template std::unique_ptr<Load<2>> make_motion();
template std::unique_ptr<Load<3>> make_motion();

} // namespace thelma
