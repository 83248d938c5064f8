#include <thelma/fields/named_dofs.h>
#include <thelma/output/observables/observables.h>

namespace thelma
{
namespace
{

/// Mean potential and temperature of the nodes of a named point, line or surface, as far as they
/// are fields.
template <int dim>
class Probe final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void declare(dealii::ParameterHandler& prm) override
  {
    prm.add_parameter("At", group,
                      "Point, line or surface whose mean potential and temperature are reported.");
  }

  void setup(const ObservableInput<dim>& scene) override
  {
    for (const Field field : {Field::potential, Field::temperature})
      if (scene.layout.has(field)) {
        dofs.push_back(dofs_on(scene.mesh, scene.layout, group, this->name.place("At"),
                               scene.layout[field].component));
        names.push_back(field == Field::potential ? "probe_phi_kV" : "probe_theta_K");
      }
  }

  std::vector<std::string> columns_of_kind() const override { return names; }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    std::vector<double> means;
    for (const auto& of_field : dofs)
      means.push_back(sum_over(of_field, scene.state.x) / of_field.size());
    return means;
  }

private:
  std::string group;
  std::vector<std::set<dealii::types::global_dof_index>> dofs;
  std::vector<std::string> names;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_probe(const ObservableName& name)
{
  return std::make_unique<Probe<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_probe(const ObservableName&);
template std::unique_ptr<Observable<3>> make_probe(const ObservableName&);

} // namespace thelma
