#include <thelma/base/option_names.h>
#include <thelma/base/parameters.h>
#include <thelma/fields/field_set.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace thelma
{

std::string field_name(const Field field)
{
  static const std::array<std::string, n_field_kinds> names{
      {"displacement u", "potential phi", "temperature theta"}};
  return names[static_cast<std::size_t>(field)];
}

template <int dim>
void FieldSet<dim>::declare(dealii::ParameterHandler& prm)
{
  {
    const Section section(prm, {"Time"});
    OptionNames<Analysis>({{"automatic", Analysis::automatic}, {"transient", Analysis::transient}})
        .declare(prm, "Analysis", analysis,
                 "`automatic`: in time where a temperature field is transient; `transient`: in "
                 "time, after the stages, under loads that follow their amplitudes.");
  }
  const Section section(prm, {"Temperature"});
  OptionNames<TemperatureModel>({{"uniform", TemperatureModel::uniform},
                                 {"steady", TemperatureModel::steady},
                                 {"transient", TemperatureModel::transient}})
      .declare(prm, "Model", temperature_model,
               "`uniform`: a number, no unknowns; `steady`: conduction in the deformed body; "
               "`transient`: the same over time, from the uniform Value at time 0.");
}

template <int dim>
void FieldSet<dim>::choose_fields(const bool if_electric)
{
  present = {Field::displacement};
  if (if_electric)
    present.push_back(Field::potential);
  if (temperature_model != TemperatureModel::uniform)
    present.push_back(Field::temperature);
  unsigned int block = 0, component = 0;
  places.fill(std::nullopt);
  for (const Field field : present) {
    const unsigned int n = field == Field::displacement ? dim : 1;
    places[static_cast<std::size_t>(field)] = FieldPlace{block++, component, n};
    component += n;
  }
}

template <int dim>
bool FieldSet<dim>::has(const Field field) const
{
  return std::find(present.begin(), present.end(), field) != present.end();
}

template <int dim>
const FieldPlace& FieldSet<dim>::operator[](const Field field) const
{
  const auto& place = places[static_cast<std::size_t>(field)];
  AssertThrow(place, dealii::ExcInternalError());
  return *place;
}

template <int dim>
unsigned int FieldSet<dim>::n_components() const
{
  const FieldPlace& last = (*this)[present.back()];
  return last.component + last.n_components;
}

template class FieldSet<2>;
template class FieldSet<3>;

} // namespace thelma
