#include <thelma/base/option_names.h>
#include <thelma/mesh/cross_section.h>

namespace thelma
{

template <int dim>
void CrossSection<dim>::declare(dealii::ParameterHandler& prm)
{
  OptionNames<Geometry>(
      {{"plane strain", Geometry::plane_strain}, {"axisymmetric", Geometry::axisymmetric}})
      .declare(prm, "Geometry", geometry,
               "What a mesh of two dimensions is: a section through a body in `plane strain`, all "
               "numbers per mm of depth; or, `axisymmetric`, half a section through a body of "
               "revolution with the radius x1 >= 0 and the axis along x3. Numbers are those of the "
               "whole body, and u1 = 0 where x1 = 0.");
}

template class CrossSection<2>;
template class CrossSection<3>;

} // namespace thelma
