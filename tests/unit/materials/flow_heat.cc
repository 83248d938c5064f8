#include "memory.h"

/// What flow dissipates and what it does to entropy.
namespace thelma
{
namespace
{

using namespace material_tests;

/// At a strain that is kept, what is stored less becomes heat.
TEST(FlowHeat, IsWhatIsNoLongerStored)
{
  const auto material = viscous();
  RandomStates random;
  constexpr double dt = 1e-5 * relaxation;
  for (unsigned int n = 0; n < 200; ++n) {
    Memory memory(*material);
    memory.step(random.deformation(), random.uniform(0.1, 3.) * relaxation);
    const Tensor3<2> F = random.deformation();
    memory.step(F, 0.);
    const PointState<> before = memory.state(F, 0.);
    const Energies stored = material->energies(before);
    const double dissipation = material->flow_heat(before).dissipation;
    EXPECT_NEAR(dissipation, stored.dissipation,
                1e-12 * dissipation); // other types round otherwise
    EXPECT_GE(dissipation, 0.);
    memory.step(F, dt);
    const double lost = stored.elastic - material->energies(memory.state(F, 0.)).elastic;
    EXPECT_NEAR(lost / dt, dissipation, 2e-4 * dissipation);
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
    const Tensor3<2> direction = random.deformation();
    const FlowHeat heat = material->flow_heat(state);
    EXPECT_NEAR(heat.eta, material->first_derivatives(state).eta, 1e-15);
    double along[2] = {0., 0.}, over_theta[2] = {0., 0.}; // of eta, dissipation
    for (const double side : {1., -1.}) {
      PointState<> there = state, hotter = state;
      there.F += side * h * direction;
      hotter.theta += side * h * state.theta;
      const FlowHeat moved = material->flow_heat(there), heated = material->flow_heat(hotter);
      along[0] += side * moved.eta / (2. * h);
      along[1] += side * moved.dissipation / (2. * h);
      over_theta[0] += side * heated.eta / (2. * h * state.theta);
      over_theta[1] += side * heated.dissipation / (2. * h * state.theta);
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
