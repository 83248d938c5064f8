#include <thelma/base/axes.h>
#include <thelma/fields/named_dofs.h>
#include <thelma/output/observables.h>

namespace thelma
{
namespace
{

/// Force with which the supports of a named surface, line or point hold the body: the reactions of
/// its nodes (exact for the discrete energy). Zero where nothing is held. In plane strain per mm.
template <int dim>
class Reaction final : public Observable<dim>
{
public:
  void declare(dealii::ParameterHandler& prm) override
  {
    prm.add_parameter(
        "At", group,
        "Surface, line or point whose supports' force on the body is wanted, in N (in "
        "plane strain N per mm of depth).");
  }

  void setup(const Scene<dim>& scene) override
  {
    for (unsigned int c = 0; c < dim; ++c)
      dofs[c] =
          dofs_on(scene.mesh, scene.layout, group, "section Observables/reaction, entry 'At'", c);
  }

  std::vector<std::string> columns() const override
  {
    std::vector<std::string> names;
    for (int c = 0; c < dim; ++c)
      names.push_back("reaction_f" + std::to_string(axis<dim>(c) + 1) + "_N");
    return names;
  }

  std::vector<double> evaluate(const Scene<dim>& scene) override
  {
    std::vector<double> forces;
    for (const auto& of_component : dofs)
      forces.push_back(sum_over(of_component, scene.system.reactions()));
    return forces;
  }

private:
  std::string group;
  std::array<std::set<dealii::types::global_dof_index>, dim> dofs;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_reaction()
{
  return std::make_unique<Reaction<dim>>();
}

template std::unique_ptr<Observable<2>> make_reaction();
template std::unique_ptr<Observable<3>> make_reaction();

} // namespace thelma
