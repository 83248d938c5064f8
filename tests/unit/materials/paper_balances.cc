#include "support.h"

/// The law of the paper (Sharma, Khurana, Joglekar) in its balance of heat: rate of entropy,
/// structural heat and the tangent of both, with the errata of theory.md corrected. Here "eq." is
/// an equation of the paper.
namespace thelma
{
namespace
{

using namespace material_tests;

/// A permittivity that depends on temperature: without one dD/dtheta = 0.
constexpr const char* electro_caloric = "set Thermal expansion = 1.8e-4\n"
                                        "set Permittivity = 5e-5, -1e-5, 2e-6";

/// Rates of F in 1/s and of E in kV/(mm s), unrelated to some_state.
const Tensor3<2> F_dot({{.2, -.1, .05}, {.3, -.15, .1}, {-.05, .2, .1}});
const Tensor3<1> E_dot({3., 5., -2.});

class PaperBalances : public testing::Test
{
protected:
  const std::unique_ptr<PaperMaterial> material = material_with<PaperMaterial>(electro_caloric);
  const Total<PaperMaterial> law = total(*material);
  const SecondDerivatives<> second = law.second(some_state);
  const Ad eta = law.first(seeded(some_state)).eta;
};

/// eq. 12 at constant temperature: eta_dot is what F_dot and E_dot make of it.
TEST_F(PaperBalances, RateOfEntropy)
{
  const double exact = contract(d_dF(eta), F_dot) + contract(d_dE(eta), E_dot);
  const double elastic = -contract(second.dP_dtheta, F_dot);
  const double electric = contract(second.dD_dtheta, E_dot);
  EXPECT_NEAR(elastic + electric, exact, 1e-12 * std::abs(exact));
}

/// eq. 13 for a body without source or conduction that is stretched and charged: c theta_dot = H
/// keeps the entropy (with the exact capacity for c).
TEST_F(PaperBalances, StructuralHeatKeepsTheEntropy)
{
  const double theta = some_state.theta, capacity = theta * second.deta_dtheta;
  const double H = theta * (contract(second.dP_dtheta, F_dot) - contract(second.dD_dtheta, E_dot));
  const double eta_dot =
      contract(d_dF(eta), F_dot) + contract(d_dE(eta), E_dot) + d_dtheta(eta) * H / capacity;
  EXPECT_NEAR(eta_dot, 0., 1e-12 * std::abs(H) / theta);
}

/// What the residual of heat depends on, and a direction in that space.
struct HeatState : PointState<> {
  Tensor3<1> gradient;
};

HeatState moved(const HeatState& state, const HeatState& direction, const double step)
{
  HeatState result = state;
  result.F += step * direction.F;
  result.E += step * direction.E;
  result.theta += step * direction.theta;
  result.gradient += step * direction.gradient;
  return result;
}

/// One quadrature point of one node's equation of heat over one backward Euler step,
///   N c (theta - theta_n)/dt - grad N . Q - N H.
class PaperHeatTangent : public testing::Test
{
protected:
  static constexpr double dt = 0.5, N = 0.3;
  const Tensor3<1> grad_N{{0.4, -0.7, 0.2}};
  const std::unique_ptr<PaperMaterial> material = material_with<PaperMaterial>(electro_caloric);
  const Total<PaperMaterial> law = total(*material);
  const Thermal& thermal = material->thermal;
  const HeatState state{some_state, Tensor3<1>({5., -3., 8.})};
  const PointState<> old{Tensor3<2>(some_state.F - dt * F_dot), some_state.E - dt* E_dot, 335.};

  double residual(const HeatState& x) const
  {
    const SecondDerivatives<> d = law.second(x);
    const double H = x.theta / dt *
                     (contract(d.dP_dtheta, Tensor3<2>(x.F - old.F)) -
                      contract(d.dD_dtheta, Tensor3<1>(x.E - old.E)));
    return N * thermal.c * (x.theta - old.theta) / dt -
           grad_N * thermal.heat_flux(Kinematics<>(x.F), x.gradient).Q - N * H;
  }

  /// eq. 19 as printed
  double conduction_and_capacity(const HeatState& v) const
  {
    const HeatFlux<> flux = thermal.heat_flux(Kinematics<>(state.F), state.gradient);
    double result = N * thermal.c / dt * v.theta - grad_N * (flux.dQ_dgrad * v.gradient);
    for (int J = 0; J < 3; ++J)
      result -= grad_N[J] * contract(flux.dQ_dF[J], v.F);
    return result;
  }

  /// The derivative of H = theta (dP/dtheta : F_dot - dD/dtheta . E_dot); third derivatives of the
  /// energy by Sacado on the hand-written second ones.
  double heat_tangent(const HeatState& v) const
  {
    const SecondDerivatives<Ad> d = law.second(seeded(state));
    const auto change = [&](const Ad& f) {
      return contract(d_dF(f), v.F) + contract(d_dE(f), v.E) + d_dtheta(f) * v.theta;
    };
    double result = 0.;
    for (int i = 0; i < 3; ++i) {
      const Ad electric = state.theta * d.dD_dtheta[i];
      result -= change(electric) * E_dot[i] + electric.val() * v.E[i] / dt;
      result -= v.theta * d.dD_dtheta[i].val() * E_dot[i];
      for (int J = 0; J < 3; ++J) {
        const Ad elastic = state.theta * d.dP_dtheta[i][J];
        result += change(elastic) * F_dot[i][J] + elastic.val() * v.F[i][J] / dt;
        result += v.theta * d.dP_dtheta[i][J].val() * F_dot[i][J];
      }
    }
    return result;
  }

  void compare(const HeatState& v) const
  {
    const double step = 1e-4;
    const double difference =
        (residual(moved(state, v, step)) - residual(moved(state, v, -step))) / (2. * step);
    EXPECT_NEAR(conduction_and_capacity(v) - N * heat_tangent(v), difference,
                1e-6 * std::abs(difference));
  }
};

TEST_F(PaperHeatTangent, Displacement)
{
  compare({{Tensor3<2>({{.5, -.3, .2}, {.1, .4, -.6}, {.3, .2, -.1}}), {}, 0.}, {}});
}

/// Zero only while the permittivity is constant.
TEST_F(PaperHeatTangent, Potential)
{
  compare({{{}, Tensor3<1>({2., -1., 3.}), 0.}, {}});
}

TEST_F(PaperHeatTangent, Temperature)
{
  compare({{{}, {}, 1.}, Tensor3<1>({.2, .3, -.5})});
}

} // namespace
} // namespace thelma
