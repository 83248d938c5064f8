#pragma once

#include <thelma/loads/load.h>

#include <string>

namespace thelma
{

inline const AmplitudeEntry heat_amplitude{"Heat", "Multiple of heat fluxes and sources"};
inline const AmplitudeEntry wall_amplitude{
    "Wall", "Part of the way from Temperature/Value to the temperatures of walls and surroundings"};

/// A load on a temperature field: there before the stages, or in time alone.
template <int dim>
class HeatLoad : public Load<dim>
{
public:
  void setup(const LoadInput<dim>& input) override { layout = &input.layout; }
  Field acts_on() const final { return Field::temperature; }
  bool has_stage() const final { return false; }
  bool is_heating() const final { return !layout->has_transient_temperature(); }

protected:
  /// Throws InputError for the @p entry if it is given and there is no temperature field.
  void require_field(const SceneEntry& entry, bool is_given) const;

  const DofLayout<dim>* layout = nullptr;
};

/// Throws InputError if the part @p level of the way from @p start to the @p wall temperature (K),
/// at the @p time (s), is no temperature.
void check_wall_temperature(double start, double wall, double time, double level);

} // namespace thelma
