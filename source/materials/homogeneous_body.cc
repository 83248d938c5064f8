#include <thelma/materials/homogeneous_body.h>

#include <algorithm>
#include <cmath>

namespace thelma
{

HomogeneousBody::HomogeneousBody(const Material& material, const MaterialTest::Mode mode)
    : material(&material), mode(mode), first_free(mode == MaterialTest::Mode::uniaxial ? 1 : 2),
      n_free(3 - first_free)
{
  for (unsigned int i = 0; i < 3; ++i)
    last.F[i][i] = 1.;
  last.theta = material.thermal.theta_0;
}

void HomogeneousBody::evaluate(const PointState<>& at)
{
  FirstDerivatives<> first{};
  SecondDerivatives<> second{};
  material->evaluate(at, first);
  material->evaluate(at, second);
  const Kinematics<> kin(at.F);
  const Volumetric<> v = material->thermal.volumetric(kin.J, at.theta);
  add_volumetric(kin, v, first);
  add_volumetric(kin, v, second);
  P = first.P;
  stiffness = 0.;
  for (unsigned int i = n_free; i < max_free; ++i) // of an axis that is not there
    stiffness[i][i] = 1.;
  for (unsigned int i = 0; i < n_free; ++i) {
    const unsigned int a = first_free + i;
    force[i] = P[a][a] * at.F[a][a];
    for (unsigned int j = 0; j < n_free; ++j) {
      const unsigned int b = first_free + j;
      stiffness[i][j] = at.F[a][a] * second.dP_dF[a][a][b][b] * at.F[b][b];
    }
    stiffness[i][i] += force[i];
  }
}

bool HomogeneousBody::find_balance(const Imposed& imposed, const double* step)
{
  constexpr unsigned int most = 50;
  constexpr double converged = 1e-9, longest = 0.5; // Newton's method is quadratic in the end
  const PointState<> before = last;
  PointState<> at = before;
  at.F[0][0] = imposed.stretch;
  if (mode == MaterialTest::Mode::equibiaxial)
    at.F[1][1] = imposed.stretch;
  const double change = dealii::determinant(before.F) / dealii::determinant(at.F);
  for (unsigned int a = first_free; a < 3; ++a) // a guess that keeps the volume
    at.F[a][a] *= std::pow(change, 1. / n_free);
  at.E[2] = imposed.field;
  at.theta = imposed.theta;
  at.history.step = step;
  for (unsigned int i = 0; i < most; ++i) {
    evaluate(at);
    const dealii::Tensor<1, max_free> way = -dealii::invert(stiffness) * force;
    const double length = way.norm();
    if (!std::isfinite(length))
      return false;
    for (unsigned int k = 0; k < n_free; ++k)
      at.F[first_free + k][first_free + k] *= std::exp(way[k] * std::min(1., longest / length));
    if (length > converged)
      continue;
    const bool is_stable = stiffness[0][0] > 0. && dealii::determinant(stiffness) > 0.;
    if (is_stable) {
      evaluate(at);
      last = at;
    }
    return is_stable;
  }
  return false;
}

} // namespace thelma
