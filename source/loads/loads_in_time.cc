// The amplitudes of the loads.

#include <thelma/base/complaints.h>
#include <thelma/loads/loads.h>

#include <algorithm>

namespace thelma
{

template <int dim>
void Loads<dim>::read_amplitudes(const std::optional<double> end)
{
  Complaints complaints;
  for (GivenAmplitude& given : amplitudes)
    complaints.allow([&]() {
      given.amplitude.emplace("section Time, entry '" + given.entry() + "'", given.text);
      if (!end)
        return;
      const AmplitudeTimes found = given.amplitude->times(*end);
      times.kinks.insert(times.kinks.end(), found.kinks.begin(), found.kinks.end());
      times.bends.insert(times.bends.end(), found.bends.begin(), found.bends.end());
    });
  complaints.raise();
}

template <int dim>
double Loads<dim>::amplitude(const std::size_t index, const double time) const
{
  const std::string name = items[index].load->amplitude();
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
std::map<std::string, std::string> Loads<dim>::idle_amplitudes() const
{
  std::map<std::string, std::string> idle;
  for (const GivenAmplitude& given : amplitudes) {
    std::string entries;
    bool multiplies = false;
    for (const Item& item : items)
      if (item.load->amplitude() == given.name) {
        multiplies = multiplies || item.load->is_present();
        entries += (entries.empty() ? "" : " or ") + item.load->entry().path();
      }
    if (!multiplies)
      idle[given.entry()] = "there is no " + entries;
  }
  return idle;
}

template class Loads<2>;
template class Loads<3>;

} // namespace thelma
