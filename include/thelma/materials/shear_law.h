#pragma once

#include <thelma/materials/point.h>
#include <thelma/materials/temperature_law.h>

namespace thelma
{

/// Elastic laws of the form W = mu(theta)/2 I(F_EM), without their volumetric energy. The @p Law
/// gives I as invariant(F, J), its half gradient I_F/2 as half_gradient(F, kin) and second(), which
/// is mu times the gradient of that. The modulus is a TemperatureLaw in MPa; default: Sharma,
/// Khurana and Joglekar, section 4.
template <class Law>
class ShearLaw
{
public:
  /// Shear modulus of the undeformed material in MPa.
  double shear_modulus(const double theta) const { return mu.value(theta); }

  std::string table_defect(const double theta) const { return mu.table_defect(theta); }

  template <typename Number>
  Number W(const Tensor3<2, Number>& F, const Number& J, const Number& theta) const
  {
    return mu.value(theta) / 2. * law().invariant(F, J);
  }

  template <typename Number>
  ElasticDerivatives<Number> first(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                                   const Number& theta) const
  {
    const Number I = law().invariant(F, kin.J);
    const Tensor3<2, Number> half_gradient = law().half_gradient(F, kin);
    ElasticDerivatives<Number> d;
    d.W = mu.value(theta) / 2. * I;
    d.W_theta = mu.slope(theta) / 2. * I;
    d.W_thetatheta = mu.curvature(theta) / 2. * I;
    d.W_F = mu.value(theta) * half_gradient;
    d.W_Ftheta = mu.slope(theta) * half_gradient;
    return d;
  }

protected:
  TemperatureLaw mu{paper_shear_modulus()};

private:
  const Law& law() const { return static_cast<const Law&>(*this); }
};

} // namespace thelma
