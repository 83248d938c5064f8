#include <thelma/base/error.h>
#include <thelma/base/input_errors.h>
#include <thelma/base/parameters.h>
#include <thelma/loads/load_list.h>
#include <thelma/loads/loads.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace thelma
{

template <int dim>
Loads<dim>::Loads()
{
  for (const std::string& name : load_kinds<dim>().names())
    items.push_back({name, load_kinds<dim>().create(name)});
  for (const Item& item : items)
    if (const std::string name = item.load->amplitude().name;
        !name.empty() && std::none_of(amplitudes.begin(), amplitudes.end(),
                                      [&](const auto& known) { return known.name == name; }))
      amplitudes.push_back({name, item.load->amplitude().meaning, "1", {}});
}

template <int dim>
void Loads<dim>::declare(dealii::ParameterHandler& prm)
{
  for (const Item& item : items)
    item.load->declare(prm);
  const Section section(prm, {"Time"});
  for (GivenAmplitude& given : amplitudes)
    prm.add_parameter(given.entry(), given.text,
                      given.meaning +
                          " over time, an expression of t (s) or a table `0: 0, 2.5: 1`.",
                      dealii::Patterns::Anything());
}

template <int dim>
std::vector<std::string> Loads<dim>::stage_names() const
{
  std::vector<std::string> names;
  for (const Item& item : items)
    names.push_back(item.load->has_stage() ? item.name : "");
  return names;
}

template <int dim>
std::size_t Loads<dim>::index(const std::string& name) const
{
  return std::find_if(items.begin(), items.end(),
                      [&](const Item& item) { return item.name == name; }) -
         items.begin();
}

template <int dim>
void Loads<dim>::setup(const LoadInput<dim>& input)
{
  conditions = input.conditions;
  InputErrors errors;
  for (std::size_t i = 0; i < items.size(); ++i) {
    errors.collect([&]() { items[i].load->setup(input); });
    if (input.loading != nullptr)
      items[i].last = input.loading->stages().last_level(i).value_or(1.);
  }
  errors.raise();
}

template <int dim>
void Loads<dim>::check(const Stages& stages) const
{
  for (std::size_t i = 0; i < items.size(); ++i)
    items[i].load->check(stages, items[i].name, i);
}

template <int dim>
void Loads<dim>::prescribe(State& state) const
{
  conditions->hold_supports(state.x);
  for (const Item& item : items)
    item.load->prescribe(state);
  state.x.update_ghost_values();
}

template <int dim>
void Loads<dim>::observe(State& state) const
{
  for (const Item& item : items)
    item.load->observe(state);
}

template <int dim>
void Loads<dim>::add_forces(const double factor, const State& state, const BlockVector& x,
                            const Counts& counts, BlockVector& nodal) const
{
  for (const Item& item : items)
    if (item.load->is_present() && counts(item.load->acts_on()))
      item.load->add_forces(factor, {item.load->level(), state.time}, state, x, nodal);
}

template <int dim>
void Loads<dim>::add_tangent(const State& state, const Counts& counts,
                             TangentEntries<dim>& tangent) const
{
  for (const Item& item : items)
    if (item.load->is_present() && counts(item.load->acts_on()))
      item.load->add_tangent(state, tangent);
}

template <int dim>
HeatInflow Loads<dim>::heat_inflow(const DofLayout<dim>& layout, const State& state) const
{
  BlockVector flows = layout.new_vector();
  add_forces(
      1., state, state.x, [](const Field field) { return field == Field::temperature; }, flows);
  const unsigned int b = layout.block(Field::temperature);
  std::vector<double> own{0., 0.}, sum(2);
  for (unsigned int i = 0; i < flows.block(b).locally_owned_size(); ++i) {
    own[0] += flows.block(b).local_element(i);
    own[1] += flows.block(b).local_element(i) / state.x.block(b).local_element(i);
  }
  dealii::Utilities::MPI::sum(own, layout.communicator(), sum);
  return {sum[0], sum[1]};
}

/// Forces are given along the way of the displacements; charges come to where the potential is.
template <int dim>
double Loads<dim>::work(const DofLayout<dim>& layout, const State& state, const Accepted& before,
                        const Accepted& now) const
{
  const auto forces = [&](const Accepted& at) {
    BlockVector nodal = layout.new_vector();
    for (std::size_t i = 0; i < items.size(); ++i)
      if (items[i].load->is_present() && items[i].load->acts_on() != Field::temperature)
        items[i].load->add_forces(1., {at.levels[i], at.time}, state, at.x, nodal);
    nodal.compress(dealii::VectorOperation::add);
    return nodal;
  };
  const BlockVector early = forces(before), late = forces(now);
  const unsigned int u = layout.block(Field::displacement);
  double twice = 0.;
  for (const BlockVector* force : {&early, &late})
    twice += force->block(u) * now.x.block(u) - force->block(u) * before.x.block(u);
  if (layout.has(Field::potential)) {
    const unsigned int phi = layout.block(Field::potential);
    for (const Accepted* at : {&before, &now})
      twice += early.block(phi) * at->x.block(phi) - late.block(phi) * at->x.block(phi);
  }
  return twice / 2.;
}

template <int dim>
std::vector<double> Loads<dim>::levels() const
{
  std::vector<double> levels;
  for (const Item& item : items)
    levels.push_back(item.load->level());
  return levels;
}

template <int dim>
void Loads<dim>::set_levels(const std::vector<double>& levels)
{
  for (std::size_t i = 0; i < items.size(); ++i)
    items[i].load->set_level(levels[i]);
}

template <int dim>
std::vector<double> Loads<dim>::heated_to(const double level) const
{
  std::vector<double> heated = levels();
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].load->is_heating())
      heated[i] = level;
  return heated;
}

template <int dim>
void Loads<dim>::read_amplitudes(const std::optional<double> end)
{
  InputErrors errors;
  for (GivenAmplitude& given : amplitudes)
    errors.collect([&]() {
      given.amplitude.emplace("section Time, entry '" + given.entry() + "'", given.text);
      if (!end)
        return;
      const AmplitudeTimes found = given.amplitude->times(*end);
      times.kinks.insert(times.kinks.end(), found.kinks.begin(), found.kinks.end());
      times.bends.insert(times.bends.end(), found.bends.begin(), found.bends.end());
    });
  errors.raise();
}

template <int dim>
double Loads<dim>::amplitude(const std::size_t index, const double time) const
{
  const std::string name = items[index].load->amplitude().name;
  const auto given = std::find_if(amplitudes.begin(), amplitudes.end(),
                                  [&](const auto& known) { return known.name == name; });
  return given == amplitudes.end() ? 1. : (*given->amplitude)(time);
}

template <int dim>
std::vector<double> Loads<dim>::levels_at(const double time) const
{
  std::vector<double> levels;
  for (std::size_t i = 0; i < items.size(); ++i)
    levels.push_back(items[i].last * amplitude(i, time));
  return levels;
}

template <int dim>
void Loads<dim>::check_levels(const double end) const
{
  constexpr unsigned int n = 100;
  for (unsigned int k = 0; k <= n; ++k) {
    const double time = end * k / n;
    const std::vector<double> levels = levels_at(time);
    for (std::size_t i = 0; i < items.size(); ++i)
      items[i].load->check_level(time, levels[i]);
  }
}

template <int dim>
bool Loads<dim>::has_amplitudes() const
{
  return std::any_of(amplitudes.begin(), amplitudes.end(),
                     [](const auto& given) { return given.text != "1"; });
}

template <int dim>
std::map<std::string, std::string> Loads<dim>::unused_amplitudes() const
{
  std::map<std::string, std::string> idle;
  for (const GivenAmplitude& given : amplitudes) {
    std::string entries;
    bool multiplies = false;
    for (const Item& item : items)
      if (item.load->amplitude().name == given.name) {
        multiplies = multiplies || item.load->is_present();
        entries += (entries.empty() ? "" : " or ") + item.load->entry().path();
      }
    if (!multiplies)
      idle[given.entry()] = "there is no " + entries;
  }
  return idle;
}

template <int dim>
void Ramp<dim>::go_to(const double load)
{
  std::vector<double> levels(from.size());
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i] = level(i, load);
  loads.set_levels(levels);
  loads.prescribe(state);
}

template class Loads<2>;
template class Loads<3>;
template class Ramp<2>;
template class Ramp<3>;

} // namespace thelma
