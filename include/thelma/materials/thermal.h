#pragma once

#include <thelma/materials/point.h>

#include <deal.II/base/parameter_handler.h>

namespace thelma
{

/// What depends on temperature alone or on J and temperature: thermal split, volumetric energy,
/// heat capacity, conduction (theory.md, eqs. 2, 13, 17, 22).
class Thermal
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Find K, if it is given by its ratio to the shear modulus @p mu (MPa at theta_0) or by
  /// Poisson's ratio. Throws InputError, with a sentence without place, if it is given twice.
  void follow(double mu);

  /// F_EM = split(theta) F with split = J_theta^{-1/3} = exp(-alpha (theta - theta_0)).
  template <typename Number>
  Number split(const Number& theta) const
  {
    using std::exp;
    return exp(-alpha * (theta - theta_0));
  }

  /// psi_v = (theta/theta_0) K/2 ln^2 J_EM and its derivatives, J_EM = J / J_theta.
  template <typename Number>
  Volumetric<Number> volumetric(const Number& J, const Number& theta) const
  {
    using std::log;
    const Number f = theta / theta_0;
    const Number x = log(J) - 3. * alpha * (theta - theta_0);
    Volumetric<Number> v;
    v.psi = f * K / 2. * x * x;
    v.p = f * K * x / J;
    v.dp_dJ = f * K * (1. - x) / (J * J);
    v.dp_dtheta = K * (x / theta_0 - 3. * alpha * f) / J;
    v.eta = -K * x * (x / (2. * theta_0) - 3. * alpha * f);
    v.deta_dtheta = 6. * alpha * K * x / theta_0 - 9. * alpha * alpha * f * K;
    return v;
  }

  /// psi_t = c [theta - theta_0 - theta ln(theta/theta_0)] - K y^2 exp(-y), y = ln J_theta.
  template <typename Number>
  Number psi(const Number& theta) const
  {
    using std::exp;
    using std::log;
    const Number y = 3. * alpha * (theta - theta_0);
    return c * (theta - theta_0 - theta * log(theta / theta_0)) - K * y * y * exp(-y);
  }

  template <typename Number>
  Number eta(const Number& theta) const
  {
    using std::exp;
    using std::log;
    const Number y = 3. * alpha * (theta - theta_0);
    return c * log(theta / theta_0) + 3. * alpha * K * y * (2. - y) * exp(-y);
  }

  template <typename Number>
  Number deta_dtheta(const Number& theta) const
  {
    using std::exp;
    const Number y = 3. * alpha * (theta - theta_0);
    return c / theta + 9. * alpha * alpha * K * (2. - 4. * y + y * y) * exp(-y);
  }

  /// Without their parts of the heat capacity c, which is taken at the nodes: psi_t, and the whole
  /// entropy @p eta.
  double coupling_psi(const double theta) const
  {
    return psi(theta) - c * (theta - theta_0 - theta * std::log(theta / theta_0));
  }
  double coupling_entropy(const double theta, const double eta) const
  {
    return eta - c * std::log(theta / theta_0);
  }

  /// Q = -k J C^{-1} Grad theta: isotropic conduction in the deformed body.
  template <typename Number>
  HeatFlux<Number> heat_flux(const Kinematics<Number>& kin,
                             const Tensor3<1, Number>& grad_theta) const
  {
    const Tensor3<2, Number>& G = kin.G;
    const Tensor3<1, Number> g = G * grad_theta, d = g * G;
    const Tensor3<2, Number> C_inv = dealii::transpose(G) * G;
    const Number k_J = k * kin.J;
    HeatFlux<Number> flux;
    flux.Q = -k_J * d;
    flux.dQ_dgrad = -k_J * C_inv;
    for (unsigned int J = 0; J < 3; ++J)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int L = 0; L < 3; ++L)
          flux.dQ_dF[J][i][L] = -k_J * (d[J] * G[i][L] - d[L] * G[i][J] - C_inv[J][L] * g[i]);
    return flux;
  }

  double theta_0 = 293.; ///< reference temperature, K
  double alpha = 0.;     ///< linear thermal expansion, 1/K
  double K = 56.552;     ///< bulk modulus, MPa (Lame's lambda: that of small strain is K + 2 mu/3)
  double c = 1.92;       ///< volumetric heat capacity, MPa/K
  double k = 0.16;       ///< conductivity, N/(s K)

private:
  double K_over_mu = 0., poisson_ratio = 0.; ///< 0: K is given
};

} // namespace thelma
