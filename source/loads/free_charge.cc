#include <thelma/loads/density_load.h>
#include <thelma/loads/load_list.h>

namespace thelma
{

/// The free charge q of eq. 4.
template <int dim>
std::unique_ptr<Load<dim>> make_free_charge()
{
  return std::make_unique<DensityLoad<dim>>(DensityKind{
      {"Loads", "Free charge"},
      "Charge per undeformed volume of regions, to which the stage `free charge` (Loading/Stages) "
      "goes; it stays with the material",
      "film: 1e-4",
      "uC/mm^3",
      Field::potential,
      DensityKind::On::regions,
      "free charge"});
}

template std::unique_ptr<Load<2>> make_free_charge();
template std::unique_ptr<Load<3>> make_free_charge();

} // namespace thelma
