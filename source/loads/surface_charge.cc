#include <thelma/loads/density_load.h>
#include <thelma/loads/load_list.h>

namespace thelma
{

/// The surface charge omega of eq. 4 where there is no electrode.
template <int dim>
std::unique_ptr<Load<dim>> make_surface_charge()
{
  return std::make_unique<DensityLoad<dim>>(DensityKind{
      {"Loads", "Surface charge"},
      "Charge per undeformed area of surfaces without electrode, to which the stage `surface "
      "charge` (Loading/Stages) goes; it stays with the material",
      "top: 1e-5",
      "uC/mm^2",
      Field::potential,
      DensityKind::On::surfaces,
      "surface charge"});
}

template std::unique_ptr<Load<2>> make_surface_charge();
template std::unique_ptr<Load<3>> make_surface_charge();

} // namespace thelma
