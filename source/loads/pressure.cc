#include <thelma/base/input_errors.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/fields/deformed_surface.h>
#include <thelma/loads/free_edges.h>
#include <thelma/loads/load_list.h>

#include <map>

namespace thelma
{
namespace
{

/// Pressures that act on surfaces of the deformed body and follow it (theory.md, eqs. 73 to 75).
template <int dim>
class Pressure final : public Load<dim>
{
public:
  void declare(dealii::ParameterHandler& prm) override
  {
    const Section section(prm, {"Loads"});
    add_quantity(prm, "Pressure", values,
                 "Pressures on surfaces, to which the stage `pressure` (Loading/Stages) goes, as "
                 "`inner: 0.002`. They act on the deformed surface and stay normal to it. The "
                 "edges of the surface must lie in symmetry planes or be held.",
                 Quantity("MPa"));
  }

  void setup(const LoadInput<dim>& input) override
  {
    layout = &input.layout;
    InputErrors errors;
    for (const auto& [name, pressure] : values)
      errors.collect([&, &name = name, &pressure = pressure]() {
        surfaces.push_back({pressure, {}});
        surfaces.back().surface.setup(input.mesh, *layout, name, entry().place());
        if (input.conditions != nullptr)
          check_edges(input.mesh, *layout, *input.conditions, name, entry().place());
      });
    errors.raise();
  }

  bool is_present() const override { return !values.empty(); }
  SceneEntry entry() const override { return {"Loads", "Pressure"}; }
  Field acts_on() const override { return Field::displacement; }
  AmplitudeEntry amplitude() const override { return {"Pressure", "Multiple of the pressures"}; }
  LevelText text() const override { return {"", " times the pressure"}; }

  /// Eq. (73).
  void add_forces(const double factor, const Instant& at, const State& /*state*/,
                  const BlockVector& x, BlockVector& nodal) const override
  {
    for (const Loaded& loaded : surfaces) {
      const double pressure = factor * at.level * loaded.pressure;
      loaded.surface.visit(*layout, x, [&](const auto& face, const auto& points) {
        for (const auto& point : points)
          for (std::size_t a = 0; a < face.nodes.size(); ++a)
            for (unsigned int i = 0; i < dim; ++i)
              nodal(face.cell->dofs[face.unknown(a, i)]) -=
                  pressure * point.shape[a] * point.area[i];
      });
    }
  }

  /// Eq. (75).
  void add_tangent(const State& state, TangentEntries<dim>& tangent) const override
  {
    std::vector<double> entries;
    for (const Loaded& loaded : surfaces) {
      const double half = this->level() * loaded.pressure / 2.;
      loaded.surface.visit(*layout, state.x, [&](const auto& face, const auto& points) {
        const std::size_t n = face.cell->dofs.size();
        entries.assign(n * n, 0.);
        for (const auto& point : points)
          for (std::size_t a = 0; a < face.nodes.size(); ++a)
            for (std::size_t b = 0; b < face.nodes.size(); ++b)
              add_pair(face, point, half, a, b, entries);
        tangent.add(face.index, *face.cell, entries);
      });
    }
  }

private:
  struct Loaded {
    double pressure; ///< MPa
    DeformedSurface<dim> surface;
  };

  /// What the nodes @p a and @p b of a face have of the tangent at a point.
  template <typename Face, typename Point>
  static void add_pair(const Face& face, const Point& point, const double half, const std::size_t a,
                       const std::size_t b, std::vector<double>& entries)
  {
    const std::size_t n = face.cell->dofs.size();
    const dealii::Tensor<1, dim> mixed =
        point.shape[a] * point.gradients[b] - point.shape[b] * point.gradients[a];
    dealii::Tensor<1, dim> around; // the circles of a body of revolution grow with u_1
    around[0] = point.shape[a] * point.shape[b] * point.curvature;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        entries[face.unknown(a, i) * n + face.unknown(b, j)] +=
            half * ((around + mixed)[j] * point.area[i] + (around - mixed)[i] * point.area[j]);
  }

  std::map<std::string, double> values;
  const DofLayout<dim>* layout = nullptr;
  std::vector<Loaded> surfaces;
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_pressure()
{
  return std::make_unique<Pressure<dim>>();
}

template std::unique_ptr<Load<2>> make_pressure();
template std::unique_ptr<Load<3>> make_pressure();

} // namespace thelma
