#include <thelma/loads/density_load.h>
#include <thelma/loads/load_list.h>

namespace thelma
{

/// The body force b of eq. 3.
template <int dim>
std::unique_ptr<Load<dim>> make_body_force()
{
  return std::make_unique<DensityLoad<dim>>(DensityKind{
      {"Loads", "Body force"},
      "Forces per undeformed volume of regions, to which the stage `body force` (Loading/Stages) "
      "goes",
      dim == 3 ? "core: 0 0 -1e-5*x1" : "core: 0 -1e-5*x1",
      "N/mm^3",
      Field::displacement,
      DensityKind::On::regions,
      "body force"});
}

template std::unique_ptr<Load<2>> make_body_force();
template std::unique_ptr<Load<3>> make_body_force();

} // namespace thelma
