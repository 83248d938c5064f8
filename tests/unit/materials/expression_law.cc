#include "support.h"

/// The energy of a parameter file against built-in laws, and its mistakes.
namespace thelma
{
namespace
{

using namespace material_tests;

using OwnEnergy = ComposedMaterial<ExpressionLaw, IdealDielectric>;

/// Everything of a law by its expression is what the built-in one has.
template <class BuiltIn>
void compare(const std::string& entries, const std::string& energy)
{
  const auto ours =
      material_with<OwnEnergy>("set Thermal expansion = 1e-4\nset Energy = " + energy);
  const auto exact = material_with<BuiltIn>("set Thermal expansion = 1e-4\n" + entries);
  RandomStates random;
  WorstErrors errors;
  for (unsigned int n = 0; n < 300; ++n) {
    const PointState<> state = random.next(*exact);
    const double mu = exact->shear_modulus(state.theta);
    errors.add("mu", ours->shear_modulus(state.theta), mu, 0.);
    errors.add("psi", ours->psi(state), exact->psi(state), mu);
    const FirstDerivatives<> first = ours->first_derivatives(state),
                             first_exact = exact->first_derivatives(state);
    errors.add("P", first.P, first_exact.P, mu);
    errors.add("eta", first.eta, first_exact.eta, exact->thermal.c);
    const SecondDerivatives<> second = ours->second_derivatives(state),
                              second_exact = exact->second_derivatives(state);
    errors.add("dP/dF", second.dP_dF, second_exact.dP_dF, mu);
    errors.add("dP/dtheta", second.dP_dtheta, second_exact.dP_dtheta, mu / 293.);
    errors.add("deta/dtheta", second.deta_dtheta, second_exact.deta_dtheta,
               exact->thermal.c / 293.);
  }
  errors.expect_below(1e-12);
}

TEST(MaterialsExpressionLaw, IsTheBuiltInLaw)
{
  compare<PaperMaterial>("", "(c_0 + c_1*1000/theta + c_2*(1000/theta)^2)/2*(I1 - 3 - 2*log(J)), "
                             "c_0: 0.506, c_1: -0.359333333333333333, c_2: 0.0667");
  compare<ComposedMaterial<MooneyRivlin, IdealDielectric>>(
      "set Shear modulus = 0.06\nset Second share = 0.3",
      "mu/2*((1 - m)*(I1 - 3) + m*(I2 - 3) - 2*(1 + m)*log(J)), mu: 0.06, m: 0.3");
  compare<ComposedMaterial<Yeoh, IdealDielectric>>(
      "set Shear modulus = 0.2\nset Yeoh ratios = -0.02, 5e-4",
      "0.1*((I1 - 3) - 0.02*(I1 - 3)^2 + 5e-4*(I1 - 3)^3 - 2*log(J))");
}

std::string complaint(const std::string& energy)
{
  const ParameterFile file = ParameterFile::from_text(
      "subsection Regions\n set Materials = all: rubber\nend\nsubsection Materials\n"
      " subsection rubber\n  set Elastic law = expression\n  set Energy = " +
      energy + "\n end\nend\n");
  try {
    MaterialLibrary library(file);
    dealii::ParameterHandler prm;
    library.declare(prm);
    file.read(prm);
    library.check(310.);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MaterialsExpressionLaw, MistakesAreNamed)
{
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"0.03*(I3 - 3)", "unknown name 'I3'"},
      {"mu*(I1 - 3), mu", "has no value"},
      {"mu*(I1 - 3), mu: soft", "not a number"},
      {"J*(I1 - 3), J: 2", "has a meaning already"},
      {"-0.03*(I1 - 3 - 2*log(J))", "must be positive"},
      {"0.03*(I1 - 3)", "a stress of 0.06 MPa; add -0.06*log(J) to the energy"}};
  for (const auto& [energy, words] : cases) {
    const std::string sentence = complaint(energy);
    EXPECT_NE(sentence.find(words), std::string::npos) << energy << " gives " << sentence;
    EXPECT_NE(sentence.find("Materials/rubber"), std::string::npos) << sentence;
  }
  EXPECT_EQ(complaint("mu/2*(I1 - 3 - 2*log(J)), mu: 0.05"), "");
}

} // namespace
} // namespace thelma
