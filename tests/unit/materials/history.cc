#include "memory.h"

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

TEST(MaterialsHistory, StaysIsochoricAndObjective)
{
  const auto material = viscous();
  RandomStates random;
  Memory memory(*material), of_observer(*material);
  double worst = 0.;
  WorstErrors errors;
  for (unsigned int n = 0; n < 1000; ++n) {
    const Tensor3<2> F = random.deformation(), R = random.rotation();
    const double dt = std::pow(10., random.uniform(-3., 3.));
    const FirstDerivatives<> before = material->first_derivatives(memory.state(F, dt)),
                             after = material->first_derivatives(of_observer.state(R * F, dt));
    memory.step(F, dt);
    of_observer.step(R * F, dt);
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
    Memory rest(*material);
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
  Memory memory(*material);
  WorstErrors errors;
  for (unsigned int n = 0; n < 1000; ++n) {
    const PointState<> step =
        memory.state(random.deformation(), std::pow(10., random.uniform(-1., 2.)));
    const Tensor3<2> P = material->first_derivatives(step).P;
    const double energy = material->energies(step).elastic;
    memory.accept(step);
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
  std::vector<Memory> memories(Lanes::n, Memory(*material));
  std::array<PointState<>, Lanes::n> states;
  std::vector<Lanes> steps(material->n_step());
  PointState<Lanes> all;
  for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
    memories[lane].step(random.deformation(), 1.);
    states[lane] = memories[lane].state(random.deformation(), 0.7);
    for (unsigned int i = 0; i < 3; ++i) {
      for (unsigned int J = 0; J < 3; ++J)
        all.F[i][J].set(lane, states[lane].F[i][J]);
      all.E[i].set(lane, states[lane].E[i]);
    }
    all.theta.set(lane, states[lane].theta);
    for (std::size_t i = 0; i < steps.size(); ++i)
      steps[i].set(lane, states[lane].history.step[i]);
  }
  all.history = {steps.data()};
  const FirstDerivatives<Lanes> together = material->first_derivatives(all);
  for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
    const Tensor3<2> alone = material->first_derivatives(states[lane]).P;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        EXPECT_NEAR(together.P[i][J][lane], alone[i][J], 1e-14);
  }
}

/// While F turns and stretches, C_v follows its equation to the order of the scheme, and each step
/// estimates its error within a factor.
TEST(MaterialsHistory, FollowsItsEquation)
{
  const auto material = viscous();
  const Tensor3<2> velocity({{0.5, .4, -.1}, {-.2, -.3, .2}, {.1, .15, -.1}});
  const double end = 1.5 * relaxation;
  const auto path = [&](const double t) {
    return Tensor3<2>(dealii::unit_symmetric_tensor<3>()) + (t + 0.3 * t * t) / 2. * velocity;
  };
  const Tensor3<2> exact = exact_C_v(path, Tensor3<2>(dealii::unit_symmetric_tensor<3>()), end);
  for (const unsigned int order : {1u, 2u}) {
    double last = 0.;
    for (const unsigned int n : {20u, 40u, 80u, 160u}) {
      Memory memory(*material);
      for (unsigned int k = 1; k <= n; ++k)
        memory.step(path(end * k / n), end / n, order);
      const double error = (memory.C_v() - exact).norm();
      std::printf("order %u, %3u steps: error of C_v %.2e", order, n, error);
      if (last > 0.) {
        std::printf(", order %.2f", std::log2(last / error));
        EXPECT_NEAR(std::log2(last / error), order, 0.2);
      }
      std::printf("\n");
      last = error;
    }
  }
}

/// Steps know what they do wrong, whatever their length and that of the step before, at most twice
/// and at least a fifth of it; where the strain rests, less.
TEST(MaterialsHistory, ErrorsAreEstimated)
{
  const auto material = viscous();
  RandomStates random;
  double least = 10., most = 0.;
  for (unsigned int n = 0; n < 300; ++n) {
    const Tensor3<2> velocity = random.deformation();
    const double speed = random.uniform(0.05, 0.3), bend = random.uniform(0.3, 1.),
                 dt = random.uniform(0.05, 0.5), before = random.uniform(0.5, 1.5) * dt;
    const auto path = [&](const double t) {
      const double x = t + before;
      return Tensor3<2>(dealii::unit_symmetric_tensor<3>()) + speed * (x + bend * x * x) * velocity;
    };
    Memory memory(*material);
    memory.step(path(-before), 1e-12);
    memory.step(path(0.), before);
    const Tensor3<2> start = memory.C_v();
    const double estimate = memory.step(path(dt), dt);
    const double error = (memory.C_v() - exact_C_v(path, start, dt)).norm();
    least = std::min(least, estimate / error);
    most = std::max(most, estimate / error);
  }
  std::printf("estimates are %.2f to %.2f times the errors\n", least, most);
  EXPECT_GT(least, 0.2);
  EXPECT_LT(most, 20.);
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
  double last = 0.;
  for (const unsigned int n : {20u, 40u, 80u}) {
    Memory memory(*material);
    memory.step(F, 0.); // the jump
    for (unsigned int k = 0; k < n; ++k)
      memory.step(F, end / n);
    const PointState<> state = memory.state(F, 0.);
    const Tensor3<2> P =
        material->first_derivatives(state).P - PaperMaterial().first_derivatives(state).P;
    const double error = (P - exact).norm() / exact.norm();
    std::printf("%3u steps: error of the stress of the branch %.2e", n, error);
    if (last > 0.) {
      std::printf(", order %.2f", std::log2(last / error));
      EXPECT_GT(std::log2(last / error), 1.8);
    }
    std::printf("\n");
    last = error;
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
      Memory memory(*material);
      for (unsigned int n = 0; n < 50; ++n) {
        const Tensor3<2> F = random.deformation();
        memory.step(F, ratio * relaxation, order);
        const Tensor3<2> C_v = memory.C_v();
        EXPECT_NEAR(dealii::determinant(C_v), 1., 1e-12);
        EXPECT_GT(C_v[0][0], 0.);
        EXPECT_GT(C_v[0][0] * C_v[1][1] - C_v[0][1] * C_v[1][0], 0.);
        EXPECT_TRUE(std::isfinite(
            material->first_derivatives(memory.state(F, ratio * relaxation, order)).P.norm()));
      }
    }
}

} // namespace
} // namespace thelma
