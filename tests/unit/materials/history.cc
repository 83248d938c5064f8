#include "support.h"

#include <array>
#include <cstdio>
#include <limits>

/// Laws with internal variables: what they remember stays sound, their limits are elastic, and they
/// follow their equation.
namespace thelma
{
namespace
{

using namespace material_tests;

using Viscous = PaperMaterial;

constexpr double modulus = 0.03, relaxation = 2.; // MPa, s

std::unique_ptr<Viscous> viscous()
{
  return material_with<Viscous>(
      "subsection Branch 1\n set Modulus = 0.03\n set Relaxation time = 2\nend", 1);
}

Tensor3<2> deviator(const Tensor3<2>& b)
{
  return b - dealii::trace(b) / 3. * Tensor3<2>(dealii::unit_symmetric_tensor<3>());
}

/// J^{-2/3} F F^T.
Tensor3<2> isochoric(const Tensor3<2>& F)
{
  return std::pow(dealii::determinant(F), -2. / 3.) * (F * dealii::transpose(F));
}

/// What the material remembers, with the components of C_v in the order 00 11 22 01 02 12.
struct Memory {
  std::array<double, 6> old{{1., 1., 1., 0., 0., 0.}}, older = old;

  PointState<> state(const Tensor3<2>& F, const double dt) const
  {
    return {F, Tensor3<1>({2., -1., 3.}), 293., {old.data(), 1. / dt}};
  }

  /// By differences of first order.
  void step(const Material& material, const Tensor3<2>& F, const double dt)
  {
    accept(material, state(F, dt));
  }

  /// By those of second order, after a step as long.
  void second_order_step(const Material& material, const Tensor3<2>& F, const double dt)
  {
    std::array<double, 6> start{};
    material.begin_step(old.data(), older.data(), 1. / 3., start.data());
    accept(material, {F, Tensor3<1>(), 293., {start.data(), 1.5 / dt}});
  }

  void accept(const Material& material, const PointState<>& state)
  {
    std::array<double, 6> now{};
    material.update_history(state, now.data());
    older = old;
    old = now;
  }
  Tensor3<2> C_v() const
  {
    return Tensor3<2>(
        {{old[0], old[3], old[4]}, {old[3], old[1], old[5]}, {old[4], old[5], old[2]}});
  }
};

TEST(MaterialsHistory, StaysIsochoricAndObjective)
{
  const auto material = viscous();
  RandomStates random;
  Memory memory, of_observer;
  double worst = 0.;
  WorstErrors errors;
  for (unsigned int n = 0; n < 1000; ++n) {
    const Tensor3<2> F = random.deformation(), R = random.rotation();
    const double dt = std::pow(10., random.uniform(-3., 3.));
    const FirstDerivatives<> before = material->first_derivatives(memory.state(F, dt)),
                             after = material->first_derivatives(of_observer.state(R * F, dt));
    memory.step(*material, F, dt);
    of_observer.step(*material, R * F, dt);
    errors.add("P", after.P, R * before.P, modulus);
    errors.add("C_v", of_observer.C_v(), memory.C_v(), 0.);
    worst = std::max(worst, std::abs(dealii::determinant(memory.C_v()) - 1.));
  }
  std::printf("largest error of det C_v after 1000 steps: %.1e\n", worst);
  EXPECT_LT(worst, 1e-13);
  errors.expect_below(1e-12);
}

/// Against an elastic law written once more: mu/2 (J^{-2/3} I_1 - 3) has P = mu dev(b) F^{-T}.
TEST(MaterialsHistory, LimitsAreElastic)
{
  const auto material = viscous();
  const PaperMaterial equilibrium;
  RandomStates random;
  WorstErrors at_once, soon, late;
  for (unsigned int n = 0; n < 1000; ++n) {
    const Tensor3<2> F = random.deformation();
    const Memory rest;
    const Tensor3<2> relaxed = equilibrium.first_derivatives(rest.state(F, 0.)).P;
    const Tensor3<2> sudden = relaxed + modulus * deviator(isochoric(F)) * Kinematics<>(F).G;
    const auto stress = [&](const double dt) {
      return material->first_derivatives(rest.state(F, dt)).P;
    };
    at_once.add("P", stress(0.), sudden, modulus);
    soon.add("P", stress(1e-10 * relaxation), sudden, modulus);
    late.add("P", stress(1e10 * relaxation), relaxed, modulus);
    late.add("P for ever", stress(std::numeric_limits<double>::infinity()), relaxed, modulus);
  }
  at_once.expect_below(1e-12);
  soon.expect_below(1e-8);
  late.expect_below(1e-8);
}

/// Once a step is accepted nothing changes until time goes on, and the energy is what is stored.
TEST(MaterialsHistory, AcceptedStepKeepsItsStress)
{
  const auto material = viscous();
  RandomStates random;
  Memory memory;
  WorstErrors errors;
  for (unsigned int n = 0; n < 1000; ++n) {
    const PointState<> step =
        memory.state(random.deformation(), std::pow(10., random.uniform(-1., 2.)));
    const Tensor3<2> P = material->first_derivatives(step).P;
    const double energy = material->energies(step).elastic;
    memory.accept(*material, step);
    const PointState<> accepted = memory.state(step.F, 0.);
    errors.add("P", material->first_derivatives(accepted).P, P, modulus);
    const double stored =
        modulus / 2. *
        (contract(dealii::invert(memory.C_v()), isochoric(Tensor3<2>(dealii::transpose(step.F)))) -
         3.);
    const double elastic = PaperMaterial().energies(accepted).elastic;
    errors.add("energy", material->energies(accepted).elastic, elastic + stored, modulus);
    errors.add("energy before", energy, elastic + stored, modulus);
  }
  errors.expect_below(1e-12);
}

/// Points in lanes are what they are alone.
TEST(MaterialsHistory, LanesAreIndependent)
{
  const auto material = viscous();
  RandomStates random;
  std::array<Memory, Lanes::n> memories;
  std::array<PointState<>, Lanes::n> states;
  std::array<Lanes, 6> old;
  PointState<Lanes> all;
  for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
    memories[lane].step(*material, random.deformation(), 1.);
    states[lane] = memories[lane].state(random.deformation(), 0.7);
    for (unsigned int i = 0; i < 3; ++i) {
      for (unsigned int J = 0; J < 3; ++J)
        all.F[i][J].set(lane, states[lane].F[i][J]);
      all.E[i].set(lane, states[lane].E[i]);
    }
    all.theta.set(lane, states[lane].theta);
    for (unsigned int i = 0; i < 6; ++i)
      old[i].set(lane, memories[lane].old[i]);
  }
  all.history = {old.data(), 1. / 0.7};
  const FirstDerivatives<Lanes> together = material->first_derivatives(all);
  for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
    const Tensor3<2> alone = material->first_derivatives(states[lane]).P;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        EXPECT_NEAR(together.P[i][J][lane], alone[i][J], 1e-14);
  }
}

/// After a jump of F the elastic strain of the branch obeys b_e' = -dev(b_e) b_e / tau (Reese and
/// Govindjee 1998), integrated here by the classical Runge-Kutta method; P = G dev(b_e) F^{-T}.
TEST(MaterialsHistory, RelaxesByItsEquation)
{
  const auto material = viscous();
  const Tensor3<2> F({{1.9, .4, -.1}, {-.2, .8, .2}, {.1, .15, .9}});
  const double end = 1.5 * relaxation;
  const auto rate = [&](const Tensor3<2>& b) { return -1. / relaxation * (deviator(b) * b); };
  Tensor3<2> b = isochoric(F);
  constexpr unsigned int n_exact = 2000;
  const double h = end / n_exact;
  for (unsigned int n = 0; n < n_exact; ++n) {
    const Tensor3<2> k1 = rate(b), k2 = rate(b + h / 2. * k1), k3 = rate(b + h / 2. * k2),
                     k4 = rate(b + h * k3);
    b += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
  }
  const Tensor3<2> exact = modulus * deviator(b) * Kinematics<>(F).G;
  for (const unsigned int order : {1u, 2u}) {
    double last = 0.;
    for (const unsigned int n : {25u, 50u, 100u, 200u}) {
      Memory memory;
      for (unsigned int k = 0; k < n; ++k)
        if (k == 0 || order == 1)
          memory.step(*material, F, end / n);
        else
          memory.second_order_step(*material, F, end / n);
      const PointState<> state = memory.state(F, 0.);
      const Tensor3<2> P =
          material->first_derivatives(state).P - PaperMaterial().first_derivatives(state).P;
      const double error = (P - exact).norm() / exact.norm();
      std::printf("order %u, %3u steps: error of the stress of the branch %.2e", order, n, error);
      if (last > 0.) {
        std::printf(", order %.2f", std::log2(last / error));
        EXPECT_NEAR(std::log2(last / error), order, 0.15);
      }
      std::printf("\n");
      last = error;
    }
  }
}

/// Whatever the length of the step over the relaxation time, and however far the strain has jumped
/// before, C_v is positive definite and isochoric, and the stress finite.
TEST(MaterialsHistory, AnyStepIsSound)
{
  const auto material = viscous();
  RandomStates random;
  for (const unsigned int order : {1u, 2u})
    for (double ratio = 1e-6; ratio < 2e6; ratio *= 10.) {
      Memory memory;
      for (unsigned int n = 0; n < 50; ++n) {
        const Tensor3<2> F = random.deformation();
        if (order == 1)
          memory.step(*material, F, ratio * relaxation);
        else
          memory.second_order_step(*material, F, ratio * relaxation);
        EXPECT_NEAR(dealii::determinant(memory.C_v()), 1., 1e-12);
        EXPECT_GT(memory.old[0] * memory.old[1] - std::pow(memory.old[3], 2), 0.);
        EXPECT_GT(memory.old[0], 0.);
        EXPECT_TRUE(std::isfinite(
            material->first_derivatives(memory.state(F, ratio * relaxation)).P.norm()));
      }
    }
}

} // namespace
} // namespace thelma
