#include "support.h"

/// Yeoh's polynomial and fibres at other entries than the defaults of oracle.cc, against Sacado and
/// in their limits.
namespace thelma
{
namespace
{

using namespace material_tests;

using YeohMaterial = ComposedMaterial<Yeoh, IdealDielectric>;
using FibreMaterial = ComposedMaterial<Fibres, IdealDielectric>;

/// All derivatives of P and psi at many states.
template <class SomeMaterial>
void compare_with_sacado(const SomeMaterial& material)
{
  RandomStates random;
  WorstErrors errors;
  for (unsigned int n = 0; n < 300; ++n) {
    const PointState<> state = random.next(material);
    const double mu = material.shear_modulus(state.theta);
    const FirstDerivatives<> ours = material.first_derivatives(state),
                             exact = derivatives_of_energy(material.psi(seeded(state)));
    errors.add("P", ours.P, exact.P, mu);
    errors.add("eta", ours.eta, exact.eta, material.thermal.c);
    const FirstDerivatives<Ad> first = material.first_derivatives(seeded(state));
    Tensor3<4> dP_dF;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        dP_dF[i][J] = d_dF(first.P[i][J]);
    errors.add("dP/dF", material.second_derivatives(state).dP_dF, dP_dF, mu);
  }
  errors.expect_below(1e-12);
}

TEST(MaterialsYeoh, AnyNumberOfTerms)
{
  for (const char* ratios : {"0.01", "-0.0128, 2.41e-4", "-0.01, 1e-3, -1e-5, 1e-7"})
    compare_with_sacado(*material_with<YeohMaterial>(std::string("set Yeoh ratios = ") + ratios));
}

/// W = C_1 x + C_2 x^2 + C_3 x^3 - 2 C_1 ln J as published coefficients have it.
TEST(MaterialsYeoh, PublishedCoefficients)
{
  const auto material =
      material_with<YeohMaterial>("set Shear modulus = 0.2\nset Yeoh ratios = -0.02, 5e-4");
  const PointState<> state{some_state.F, Tensor3<1>(), material->thermal.theta_0};
  const double x = contract(state.F, state.F) - 3., C_1 = 0.1, C_2 = -0.002, C_3 = 5e-5;
  EXPECT_NEAR(material->energies(state).elastic,
              C_1 * x + C_2 * x * x + C_3 * x * x * x -
                  2. * C_1 * std::log(dealii::determinant(state.F)),
              1e-15);
}

TEST(MaterialsFibres, DerivativesWithSeveralFamilies)
{
  for (const char* entries :
       {"set Fibre stiffness = 1\nset Fibre angles = 20",
        "set Fibre stiffness = 0.2, -0.05\nset Fibre exponent = 0.05\nset Fibre angles = 0, 35, "
        "-70",
        "set Fibre exponent = 1e-9\nset Fibre plane = x2-x3\nset Fibre angles = 90"})
    compare_with_sacado(*material_with<FibreMaterial>(entries));
}

/// A fibre along x1, or x3, in a body that is stretched along it and along the others.
TEST(MaterialsFibres, OnlyInTension)
{
  const std::string entries = "set Shear modulus = 0.05\nset Fibre stiffness = 2\n"
                              "set Fibre exponent = 0.3\n";
  const auto along_x1 = material_with<FibreMaterial>(entries + "set Fibre angles = 0");
  const auto along_x3 =
      material_with<FibreMaterial>(entries + "set Fibre angles = 90\nset Fibre plane = x1-x3");
  const auto matrix = material_with<PaperMaterial>("set Shear modulus = 0.05");
  PointState<> state{Tensor3<2>({{1.2, 0., 0.}, {0., 1.1, 0.}, {0., 0., 0.8}}), Tensor3<1>(), 293.};
  const double x = 1.2 * 1.2 - 1., stress = 2. * 2. * x * std::exp(0.3 * x * x) * 1.2;
  const Tensor3<2> alone = matrix->first_derivatives(state).P,
                   reinforced = along_x1->first_derivatives(state).P;
  EXPECT_NEAR(reinforced[0][0] - alone[0][0], stress, 1e-14);
  EXPECT_NEAR(reinforced[1][1], alone[1][1], 1e-15);
  EXPECT_NEAR(along_x1->energies(state).elastic - matrix->energies(state).elastic,
              2. / 0.6 * std::expm1(0.3 * x * x), 1e-14);
  EXPECT_NEAR((along_x3->first_derivatives(state).P - alone).norm(), 0., 1e-15);
  EXPECT_NEAR(
      (along_x3->second_derivatives(state).dP_dF - matrix->second_derivatives(state).dP_dF).norm(),
      0., 1e-15);
}

/// Where a fibre gets its tension its stress is continuous, and its stiffness jumps by 4 k_1.
TEST(MaterialsFibres, StiffnessJumps)
{
  const auto material =
      material_with<FibreMaterial>("set Shear modulus = 0.05\n"
                                   "set Fibre stiffness = 2\nset Fibre angles = 0");
  const auto at = [](const double stretch) {
    PointState<> state{Tensor3<2>(dealii::unit_symmetric_tensor<3>()), Tensor3<1>(), 293.};
    state.F[0][0] = stretch;
    return state;
  };
  const PointState<> before = at(1. - 1e-12), after = at(1. + 1e-12);
  EXPECT_NEAR((material->first_derivatives(after).P - material->first_derivatives(before).P).norm(),
              0., 1e-10);
  EXPECT_NEAR(material->second_derivatives(after).dP_dF[0][0][0][0] -
                  material->second_derivatives(before).dP_dF[0][0][0][0],
              4. * 2., 1e-9);
}

} // namespace
} // namespace thelma
