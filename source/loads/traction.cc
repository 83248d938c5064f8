#include <thelma/loads/density_load.h>
#include <thelma/loads/load_list.h>

namespace thelma
{

/// The dead traction of eq. 3 per undeformed area.
template <int dim>
std::unique_ptr<Load<dim>> make_traction()
{
  return std::make_unique<DensityLoad<dim>>(DensityKind{
      {"Loads", "Traction"},
      "Forces per undeformed area of surfaces, to which the stage `traction` (Loading/Stages) "
      "goes; they keep their direction",
      dim == 3 ? "top: 0 0 0.01*sin(pi*x1)" : "top: 0 0.01*sin(pi*x1)",
      "MPa",
      Field::displacement,
      DensityKind::On::surfaces,
      "traction"});
}

template std::unique_ptr<Load<2>> make_traction();
template std::unique_ptr<Load<3>> make_traction();

} // namespace thelma
