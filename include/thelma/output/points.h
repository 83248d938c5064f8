#pragma once

#include <thelma/elements/integrate.h>
#include <thelma/output/observables/observables.h>

#include <optional>

namespace thelma
{

/// The points of the full Gauss rule, where observables look at the state.
template <int dim>
class Points
{
public:
  void setup(const ObservableInput<dim>& scene)
  {
    rule.emplace(scene.layout, scene.layout.degree() + 1);
  }

  /// Call @p visit(point state, material, volume in mm^dim) at each point of the own cells.
  template <typename Visitor>
  void visit(const ObservableInput<dim>& scene, const Visitor& visit) const
  {
    scene.system.cells.for_each([&](const CellView<dim>& view) {
      for (unsigned int q = 0; q < rule->basis().n_points; ++q) {
        const auto& point = rule->of_cell(view.index)[q];
        visit(point_state(view, Gradients<dim>(rule->basis(), q, point)), *view.cell.material,
              point.JxW);
      }
    });
  }

private:
  std::optional<Integration<dim>> rule;
};

} // namespace thelma
