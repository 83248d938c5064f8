#include <thelma/elements/formulation.h>

namespace thelma
{

/// The element formulations a .prm can choose.
template <int dim>
const NamedList<Formulation<dim>>& formulations()
{
  static const NamedList<Formulation<dim>> list("unknown element formulation",
                                                {{"selective reduced", make_selective_reduced<dim>},
                                                 {"mean dilatation", make_mean_dilatation<dim>},
                                                 {"enhanced strain", make_enhanced_strain<dim>},
                                                 {"standard", make_standard<dim>}});
  return list;
}

template const NamedList<Formulation<2>>& formulations();
template const NamedList<Formulation<3>>& formulations();

} // namespace thelma
