#pragma once

#include <thelma/base/distribution.h>
#include <thelma/loads/nodal_forces.h>

#include <string>

namespace thelma
{

/// A dead load on displacements or potential: per volume of undeformed regions, or per area of
/// undeformed surfaces.
struct DensityKind {
  enum class On { regions, surfaces };

  SceneEntry entry;
  std::string sentence, example, unit;
  Field field;
  On on;
  std::string noun; ///< "body force"
};

/// A load of this kind; forces have the components of the scene, charges one.
template <int dim>
class DensityLoad final : public Load<dim>
{
public:
  explicit DensityLoad(DensityKind kind) : kind(std::move(kind)) {}

  void declare(dealii::ParameterHandler& prm) override;
  void setup(const LoadInput<dim>& input) override;

  bool is_present() const override { return !densities.empty(); }
  SceneEntry entry() const override { return kind.entry; }
  Field acts_on() const override { return kind.field; }
  bool is_dead() const override { return kind.field == Field::displacement; }
  AmplitudeEntry amplitude() const override
  {
    return {kind.entry.name, "Multiple of the " + kind.noun};
  }
  LevelText text() const override { return {"", " times the " + kind.noun}; }

  void add_forces(const double factor, const Instant& at, const State& /*state*/,
                  const BlockVector& /*x*/, BlockVector& nodal) const override
  {
    forces.add(factor * at.level, at.time, nodal);
  }

private:
  unsigned int n_components() const { return kind.field == Field::displacement ? dim : 1; }

  /// Forces of potentials are minus charges.
  double sign() const { return kind.field == Field::potential ? -1. : 1.; }
  void integrate_regions(double time, BlockVector& nodal) const;
  void integrate_surfaces(double time, BlockVector& nodal) const;

  /// Throws InputError where the region or surface @p name has not the field, or is inside.
  void require_field(const std::string& name) const;

  DensityKind kind;
  Distributions<dim> densities;
  const Mesh<dim>* mesh = nullptr;
  const DofLayout<dim>* layout = nullptr;
  NodalForces<dim> forces;
};

} // namespace thelma
