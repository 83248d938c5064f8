#include <thelma/base/axes.h>
#include <thelma/output/observables.h>

namespace thelma
{

/// The observables a .prm can choose.
template <int dim>
const NamedList<Observable<dim>>& observables()
{
  static const NamedList<Observable<dim>> list = []() {
    std::vector<std::pair<std::string, typename NamedList<Observable<dim>>::Factory>> entries{
        {"charge", make_charge<dim>},
        {"electrodes", make_electrodes<dim>},
        {"energy", make_energy<dim>},
        {"reaction", make_reaction<dim>},
        {"volume", make_volume<dim>},
        {"enclosed_volume", make_enclosed_volume<dim>},
        {"det_F", make_det_F<dim>},
        {"breakdown", make_breakdown<dim>},
        {"ledger", make_ledger<dim>},
        {"probe", make_probe<dim>},
        {"temperature_range", make_temperature_range<dim>}};
    for (const std::string name : {"tip", "centre"})
      entries.emplace_back(name, [name]() { return make_displacement<dim>(name); });
    for (const std::string name : {"mid_rotation", "end_rotation"})
      entries.emplace_back(name, [name]() { return make_rotation<dim>(name); });
    for (unsigned int i = 0; i < dim; ++i)
      entries.emplace_back("lambda_" + std::to_string(axis<dim>(i) + 1),
                           [i]() { return make_stretch<dim>(i); });
    return NamedList<Observable<dim>>("unknown observable", entries);
  }();
  return list;
}

template const NamedList<Observable<2>>& observables();
template const NamedList<Observable<3>>& observables();

} // namespace thelma
