#include <thelma/elements/formulation.h>

namespace thelma
{

/// The element formulations a .prm can choose.
template <int dim>
const NamedList<Formulation<dim>>& formulations()
{
  static const NamedList<Formulation<dim>> list(
      "unknown element formulation",
      {{{"selective reduced",
         "volumetric energy with one point less per direction, as in the paper"},
        make_selective_reduced<dim>},
       {{"mean dilatation",
         "pressures and dilatations of cells: Q1/P0, Q2/P1; no locking at degree 2"},
        make_mean_dilatation<dim>},
       {{"enhanced strain", "for thin bodies in bending at degree 1; can be unstable when pressed"},
        make_enhanced_strain<dim>},
       {{"standard", "full integration; locks"}, make_standard<dim>}});
  return list;
}

template const NamedList<Formulation<2>>& formulations();
template const NamedList<Formulation<3>>& formulations();

} // namespace thelma
