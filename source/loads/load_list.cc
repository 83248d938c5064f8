#include <thelma/loads/load_list.h>

namespace thelma
{

template <int dim>
const NamedList<Load<dim>>& load_kinds()
{
  static const NamedList<Load<dim>> list(
      "unknown load",
      {{{"temperature", "uniform, or at which walls and surroundings begin"},
        make_uniform_temperature<dim>},
       {{"walls", "surfaces of given temperature"}, make_wall_temperature<dim>},
       {{"voltage", "of the source that drives electrodes"}, make_voltage<dim>},
       {{"charge", "of floating electrodes"}, make_charge<dim>},
       {{"force", "on surfaces, of fixed direction"}, make_force<dim>},
       {{"traction", "force per area of surfaces, of fixed direction"}, make_traction<dim>},
       {{"body force", "force per volume of regions"}, make_body_force<dim>},
       {{"gravity", "weight of all regions"}, make_gravity<dim>},
       {{"free charge", "charge per volume of regions"}, make_free_charge<dim>},
       {{"surface charge", "charge per area of surfaces"}, make_surface_charge<dim>},
       {{"pressure", "on deformed surfaces"}, make_pressure<dim>},
       {{"move", "supports that move"}, make_motion<dim>},
       {{"flux", "heat flux through surfaces"}, make_heat_flux<dim>},
       {{"convection", "heat exchange with the surroundings"}, make_convection<dim>},
       {{"source", "heat source in regions"}, make_heat_source<dim>}});
  return list;
}

template const NamedList<Load<2>>& load_kinds();
template const NamedList<Load<3>>& load_kinds();

} // namespace thelma
