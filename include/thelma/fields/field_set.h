#pragma once

#include <deal.II/base/parameter_handler.h>
#include <deal.II/fe/fe_values_extractors.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// In the order of their blocks and components. A new scalar field is a line here and one in
/// field_name().
enum class Field { displacement, potential, temperature };
constexpr std::size_t n_field_kinds = 3;

/// Which of them a system solves for; the others are given. Displacement and potential together are
/// the deformation.
enum class Solved { all, deformation, temperature };

/// Whether the @p field is among those @p solved for.
inline bool includes(const Solved solved, const Field field)
{
  return solved == Solved::all || (field == Field::temperature) == (solved == Solved::temperature);
}

/// "displacement u", "potential phi", "temperature theta".
std::string field_name(Field field);

/// Where a field stands among the components and blocks of all fields.
struct FieldPlace {
  unsigned int block, component; ///< the first of a vector
  unsigned int n_components;

  dealii::FEValuesExtractors::Scalar scalar() const
  {
    return dealii::FEValuesExtractors::Scalar(component);
  }
  dealii::FEValuesExtractors::Vector vector() const
  {
    return dealii::FEValuesExtractors::Vector(component);
  }
};

/// The fields of a scene, in the order of their blocks and components.
template <int dim>
class FieldSet
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Whether the scene evolves in time, and whether its temperature does so as a field.
  bool is_transient() const
  {
    return analysis == Analysis::transient || has_transient_temperature();
  }
  bool has_transient_temperature() const
  {
    return temperature_model == TemperatureModel::transient;
  }

  const std::vector<Field>& fields() const { return present; }
  bool has(Field field) const;

  /// Of a field that is there.
  const FieldPlace& operator[](Field field) const;
  unsigned int block(const Field field) const { return (*this)[field].block; }
  unsigned int n_components() const;

protected:
  /// Choose the fields; a potential only @p if_electric.
  void choose_fields(bool if_electric);

private:
  enum class TemperatureModel { uniform, steady, transient };
  enum class Analysis { automatic, transient };

  TemperatureModel temperature_model = TemperatureModel::uniform;
  Analysis analysis = Analysis::automatic;
  std::vector<Field> present;
  std::array<std::optional<FieldPlace>, n_field_kinds> places;
};

} // namespace thelma
