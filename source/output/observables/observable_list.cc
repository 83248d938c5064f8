#include <thelma/base/axes.h>
#include <thelma/output/observables/observables.h>

namespace thelma
{

/// The observables a .prm can choose.
template <int dim>
const NamedList<Observable<dim>, ObservableName>& observables()
{
  using Kinds = NamedList<Observable<dim>, ObservableName>;
  static const Kinds list = []() {
    std::vector<typename Kinds::Entry> entries{
        {{"charge", "charge on the driven electrodes of positive potential, and capacitance"},
         make_charge<dim>},
        {{"electrodes", "potential, charge and capacitance of each electrode"},
         make_electrodes<dim>},
        {{"energy", "stored elastic and electric energy"}, make_energy<dim>},
        {{"reaction", "force of the supports on a surface, line or point"}, make_reaction<dim>},
        {{"volume", "volume of the deformed body relative to the undeformed one"},
         make_volume<dim>},
        {{"enclosed_volume", "volume between a surface and the symmetry planes"},
         make_enclosed_volume<dim>},
        {{"det_F", "largest det F; the smallest is in every curve"}, make_det_F<dim>},
        {{"breakdown", "largest true electric field and its ratio to the breakdown field"},
         make_breakdown<dim>},
        {{"ledger", "energy and entropy balance: stored, supplied, produced, imbalance"},
         make_ledger<dim>},
        {{"probe", "mean potential and temperature of a surface, line or point"}, make_probe<dim>},
        {{"temperature_range", "lowest and highest temperature"}, make_temperature_range<dim>}};
    for (const std::string name : {"displacement", "tip", "centre"})
      entries.push_back(
          {{name, "mean displacement of a surface, line or point"}, make_displacement<dim>});
    for (const std::string name : {"rotation", "mid_rotation", "end_rotation"})
      entries.push_back({{name, "rotation about x2 of a section x3 = const"}, make_rotation<dim>});
    for (unsigned int i = 0; i < dim; ++i) {
      const std::string number = std::to_string(axis<dim>(i) + 1);
      entries.push_back(
          {{"lambda_" + number, "mean stretch along x" + number + " between two surfaces"},
           [i](const ObservableName& name) { return make_stretch<dim>(name, i); }});
    }
    return Kinds("unknown observable", entries);
  }();
  return list;
}

template const NamedList<Observable<2>, ObservableName>& observables();
template const NamedList<Observable<3>, ObservableName>& observables();

} // namespace thelma
