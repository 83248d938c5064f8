#include "memory.h"

/// What flow dissipates and what it does to entropy.
namespace thelma
{
namespace
{

using namespace material_tests;

constexpr double theta = 293.; // K, at which a Memory stands

/// At a strain that is kept, what is stored less becomes heat, however long the step.
TEST(FlowHeat, IsWhatIsNoLongerStored)
{
  const auto material = viscous();
  RandomStates random;
  for (unsigned int n = 0; n < 200; ++n) {
    Memory memory(*material);
    memory.step(random.deformation(), random.uniform(0.1, 3.) * relaxation);
    const Tensor3<2> F = random.deformation();
    memory.step(F, 0.);
    for (const double dt : {1e-5, 1e-2, 1e3}) {
      const double stored = material->energies(memory.state(F, 0.)).elastic;
      const PointState<> end = memory.state(F, dt * relaxation);
      const FlowHeat heat = material->flow_heat(end, memory.now());
      memory.accept(end);
      const double lost = stored - material->energies(memory.state(F, 0.)).elastic;
      EXPECT_GE(heat.dissipated, 0.);
      EXPECT_NEAR(lost, heat.dissipated, 1e-12 * stored);
      const Dissipated<> again = material->dissipated(memory.before(), memory.now());
      EXPECT_NEAR(heat.dissipated, again.energy, 1e-12 * stored); // other types round otherwise
      EXPECT_NEAR(theta * again.entropy, again.energy, 1e-14 * stored);
    }
  }
}

/// Steps many times as long as the relaxation time follow the strain; the dissipation is then that
/// of a viscous fluid, D = G/(2 tau) |dev b|^2 with b = 1 + tau dC_iso/dt: no rule may drown it.
TEST(FlowHeat, IsThatOfAFluidInLongSteps)
{
  const auto material = viscous();
  RandomStates random;
  for (unsigned int n = 0; n < 50; ++n) {
    const Tensor3<2> start = random.deformation(), way = random.deformation();
    Memory memory(*material);
    constexpr double dt = 100. * relaxation, part = 0.01; // of the way in a step
    memory.step(start, std::numeric_limits<double>::infinity());
    double sum = 0., known = 0.;
    for (unsigned int k = 1; k <= 3; ++k) {
      memory.step(start + k * part * way, dt);
      sum = material->dissipated(memory.before(), memory.now()).energy;
      const Tensor3<2> C = symmetric(memory.now()),
                       rate = 1. / dt * (C - symmetric(memory.before())),
                       b = relaxation * rate * dealii::invert(C);
      const Tensor3<2> b_dev = deviator(b);
      known =
          modulus / (2. * relaxation) * dt * contract(Tensor3<2>(dealii::transpose(b_dev)), b_dev);
    }
    EXPECT_NEAR(sum, known, 0.1 * known);
  }
}

/// What is dissipated while F follows a path from rest: the integral of D = G/(2 tau) |dev b|^2 by
/// Simpson's rule.
template <typename Path>
double integral_of_dissipation(const Path& path, const double end)
{
  constexpr unsigned int n = 400, within = 10;
  const double h = end / n;
  Tensor3<2> C_v(dealii::unit_symmetric_tensor<3>());
  double sum = 0.;
  for (unsigned int k = 0; k <= n; ++k) {
    const Tensor3<2> F = path(k * h), C = isochoric(Tensor3<2>(dealii::transpose(F))),
                     b = C * dealii::invert(C_v), b_dev = deviator(b);
    const double weight = k == 0 || k == n ? 1. : k % 2 == 1 ? 4. : 2.;
    sum += weight * h / 3. * modulus / (2. * relaxation) *
           contract(Tensor3<2>(dealii::transpose(b_dev)), b_dev);
    C_v = exact_C_v([&](const double t) { return path(k * h + t); }, C_v, h, within);
  }
  return sum;
}

/// The sum over a history is of second order.
TEST(FlowHeat, ConvergesToTheIntegral)
{
  const auto material = viscous();
  RandomStates random;
  for (unsigned int n = 0; n < 10; ++n) {
    const Tensor3<2> way = 0.3 * random.deformation();
    const auto path = [&](const double t) {
      return Tensor3<2>(dealii::unit_symmetric_tensor<3>()) + std::sin(t) * way;
    };
    const auto sum = [&](const unsigned int n_steps) {
      Memory memory(*material);
      double dissipated = 0.;
      for (unsigned int k = 1; k <= n_steps; ++k) {
        memory.step(path(3. * k / n_steps), 3. / n_steps);
        dissipated += material->dissipated(memory.before(), memory.now()).energy;
      }
      return dissipated;
    };
    const double exact = integral_of_dissipation(path, 3.);
    const double coarse = sum(80) - exact, fine = sum(160) - exact;
    EXPECT_LT(std::abs(fine), 1e-3 * exact);
    EXPECT_NEAR(std::log2(coarse / fine), 2., 0.2);
  }
}

/// Its derivatives by F and theta, with what becomes of C_v on the way, by central differences.
TEST(FlowHeat, HasItsDerivatives)
{
  const auto material = material_with<PaperMaterial>(
      "set Thermal expansion = 1.8e-4\nset Heat capacity = 0\n"
      "subsection Branch 1\n set Modulus = 0.4, -0.1, 0.01\n set Relaxation time = 2\n"
      " set Shift = Arrhenius\nend",
      1);
  RandomStates random;
  constexpr double h = 1e-5;
  WorstErrors errors;
  for (unsigned int n = 0; n < 200; ++n) {
    const PointState<> state = random.next(*material);
    const double* old = random.remembered();
    const Tensor3<2> direction = random.deformation();
    const FlowHeat heat = material->flow_heat(state, old);
    EXPECT_NEAR(heat.eta, material->first_derivatives(state).eta, 1e-15);
    double along[2] = {0., 0.}, over_theta[2] = {0., 0.}; // of eta, what is dissipated
    for (const double side : {1., -1.}) {
      PointState<> there = state, hotter = state;
      there.F += side * h * direction;
      hotter.theta += side * h * state.theta;
      const FlowHeat moved = material->flow_heat(there, old),
                     heated = material->flow_heat(hotter, old);
      along[0] += side * moved.eta / (2. * h);
      along[1] += side * moved.dissipated / (2. * h);
      over_theta[0] += side * heated.eta / (2. * h * state.theta);
      over_theta[1] += side * heated.dissipated / (2. * h * state.theta);
    }
    const double size = heat.deta_dF.norm() * direction.norm(),
                 of_dissipation = heat.dD_dF.norm() * direction.norm() + 1e-12;
    errors.add("deta/dF", contract(heat.deta_dF, direction), along[0], size);
    errors.add("dD/dF", contract(heat.dD_dF, direction), along[1], of_dissipation);
    errors.add("deta/dtheta", heat.deta_dtheta, over_theta[0], size / state.theta);
    errors.add("dD/dtheta", heat.dD_dtheta, over_theta[1], of_dissipation / state.theta);
  }
  errors.expect_below(1e-6);
}

} // namespace
} // namespace thelma
