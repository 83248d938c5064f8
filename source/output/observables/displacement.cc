#include <thelma/base/axes.h>
#include <thelma/fields/named_dofs.h>
#include <thelma/output/observables/observables.h>

namespace thelma
{
namespace
{

/// Mean displacement of the nodes of a named point, line or surface: `displacement_u1_mm`, ...
template <int dim>
class Displacement final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void declare(dealii::ParameterHandler& prm) override
  {
    prm.add_parameter("At", group, "Point, line or surface whose mean displacement is reported.");
  }

  void setup(const ObservableInput<dim>& scene) override
  {
    const std::string place = this->name.place("At");
    for (unsigned int c = 0; c < dim; ++c)
      dofs[c] = dofs_on(scene.mesh, scene.layout, group, place, c);
  }

  std::vector<std::string> columns_of_kind() const override
  {
    std::vector<std::string> names;
    for (int c = 0; c < dim; ++c)
      names.push_back(this->name.kind + "_" + component_name<dim>(c) + "_mm");
    return names;
  }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    std::vector<double> means;
    for (const auto& of_component : dofs)
      means.push_back(sum_over(of_component, scene.state.x) / of_component.size());
    return means;
  }

private:
  std::string group;
  std::array<std::set<dealii::types::global_dof_index>, dim> dofs;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_displacement(const ObservableName& name)
{
  return std::make_unique<Displacement<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_displacement(const ObservableName&);
template std::unique_ptr<Observable<3>> make_displacement(const ObservableName&);

} // namespace thelma
