#include <thelma/base/axes.h>
#include <thelma/fields/named_dofs.h>
#include <thelma/output/observables/observables.h>

#include <algorithm>
#include <array>
#include <set>

namespace thelma
{
namespace
{

/// Force with which a named surface, line or point holds the body: the reactions of its nodes
/// (exact for the discrete energy) in the components that it holds itself. What others hold at
/// nodes that they share is theirs, in the same component it is both's. Where the name is no
/// support, the force of all supports on its nodes. In plane strain per mm.
template <int dim>
class Reaction final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void declare(dealii::ParameterHandler& prm) override
  {
    prm.add_parameter(
        "At", group,
        "Support whose force on the body is reported, in N (in plane strain N per mm of depth), in "
        "the directions that it holds; for a surface, line or point that is not a support, the "
        "force of all supports on its nodes.");
  }

  void setup(const ObservableInput<dim>& scene) override
  {
    std::array<std::vector<std::string>, dim> holding;
    bool is_support = false;
    for (unsigned int c = 0; c < dim; ++c) {
      holding[c] = scene.conditions.holding(c);
      is_support = is_support || contains(holding[c], group);
    }
    for (unsigned int c = 0; c < dim; ++c)
      if (const auto found = dofs_at(scene, group, c); !is_support)
        dofs[c] = found;
      else if (contains(holding[c], group)) {
        dofs[c] = found;
        note_shared(scene, c, holding[c]);
      }
  }

  std::vector<std::string> remarks() const override { return shared; }

  std::vector<std::string> columns_of_kind() const override
  {
    std::vector<std::string> names;
    for (int c = 0; c < dim; ++c)
      names.push_back(force_column(c));
    return names;
  }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    std::vector<double> forces;
    for (const auto& of_component : dofs)
      forces.push_back(sum_over(of_component, scene.system.reactions()));
    return forces;
  }

private:
  static std::string force_column(const unsigned int c)
  {
    return "reaction_f" + std::to_string(axis<dim>(c) + 1) + "_N";
  }

  using Dofs = std::set<dealii::types::global_dof_index>;

  static bool contains(const std::vector<std::string>& names, const std::string& name)
  {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  Dofs dofs_at(const ObservableInput<dim>& scene, const std::string& entity,
               const unsigned int c) const
  {
    return dofs_on(scene.mesh, scene.layout, entity, this->name.place("At"), c);
  }

  /// A node that two supports hold in one direction does not tell which of them bears its force.
  void note_shared(const ObservableInput<dim>& scene, const unsigned int c,
                   const std::vector<std::string>& holding)
  {
    const std::string number = std::to_string(axis<dim>(c) + 1);
    for (const std::string& other : holding) {
      const Dofs theirs = dofs_at(scene, other, c);
      const bool is_shared = std::any_of(dofs[c].begin(), dofs[c].end(),
                                         [&](const auto dof) { return theirs.count(dof) > 0; });
      if (other != group && is_shared)
        shared.push_back(this->name.column(force_column(c)) + " includes the force of '" + other +
                         "', which also holds u" + number + " at the nodes it shares with '" +
                         group + "'");
    }
  }

  std::string group;
  std::array<Dofs, dim> dofs;
  std::vector<std::string> shared;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_reaction(const ObservableName& name)
{
  return std::make_unique<Reaction<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_reaction(const ObservableName&);
template std::unique_ptr<Observable<3>> make_reaction(const ObservableName&);

} // namespace thelma
