#include <thelma/elements/stabilisation.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace thelma
{
namespace
{

using Vector = Tensor3<1>;

Vector unit_vector(const unsigned int axis)
{
  Vector e;
  e[axis] = 1.;
  return e;
}

/// Modulus of the strain n x n of the deformed body against the strain l x l, at fixed E.
double modulus(const SecondDerivatives<>& d, const Tensor3<2>& F, const Vector& n, const Vector& l)
{
  const Vector N = n * F, L = l * F;
  double sum = 0.;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int J = 0; J < 3; ++J)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int M = 0; M < 3; ++M)
          sum += n[i] * N[J] * d.dP_dF[i][J][k][M] * l[k] * L[M];
  return sum;
}

/// A thick body against a thin film, in which field its surface becomes wavy (theory.md, eq. 29);
/// @p q is the stretch along the wave over that across the film.
double surface_factor(const double q)
{
  return (q * q * q + q * q + 3. * q - 1.) / ((q + 1.) * (q * q + 3.));
}

/// Directions of waves along a film with normal @p m: in space four, 45 degrees apart.
std::vector<Vector> directions(const Vector& m, const int dim)
{
  Vector s = dealii::cross_product_3d(unit_vector(dim == 2 || std::abs(m[1]) < 0.7 ? 1 : 0), m);
  s /= s.norm();
  if (dim == 2)
    return {s};
  const Vector t = dealii::cross_product_3d(m, s);
  return {s, t, (s + t) / std::sqrt(2.), (s - t) / std::sqrt(2.)};
}

} // namespace

double needed_stabilisation(const Material& material, const PointState<>& state,
                            const double pressure, const int dim, const double most)
{
  constexpr double weak = 0.5; // below all X_0/mu
  const Kinematics<> kin(state.F);
  const Vector g = kin.G * state.E;
  const double field = g.norm(), mu = material.shear_modulus(state.theta);
  if (!(kin.J > 0.) || material.permittivity(state.theta) * kin.J * field * field < weak * mu)
    return 0.;
  SecondDerivatives<> d{};
  material.evaluate(state, d);
  const Vector m = g / field, M = m * state.F;
  const double X = (M * (d.dD_dE * M)) * field * field, B = modulus(d, state.F, m, m) + X;
  double needed = 0.;
  for (const Vector& s : directions(m, dim)) {
    const double A = modulus(d, state.F, s, s), C = modulus(d, state.F, s, m) + pressure * kin.J;
    const double r = surface_factor((s * state.F).norm() * (m * kin.G).norm());
    const double X_0 = r * (B - C * C / A), X_1 = r * (A + B - 2. * C);
    const double excess = std::max(0., X - X_0), enough = 1000. * mu + 10. * A;
    const double safety = std::min(2. + 8. * excess / mu, 12.);
    const double wanted = safety * A * excess / (X_1 - X);
    needed = std::max(needed, X < X_1 ? std::min(wanted, enough) : enough);
  }
  return std::min(most, needed / (kin.J * kin.J));
}

} // namespace thelma
