#pragma once

#include <thelma/materials/langevin.h>
#include <thelma/materials/shear_law.h>

namespace thelma
{

/// Arruda and Boyce's eight chains (J. Mech. Phys. Solids 41 (1993) 389) with the inverse Langevin
/// function itself, not a series (theory.md, eq. 7), without their volumetric energy:
///   W = G(theta) (lambda_L^2 (r beta - ln(sinh beta/beta))|_rest^now - a_0 ln J),
///   W_F = G (a F - a_0 F^{-T}),
///   r = sqrt(F : F/3)/lambda_L,   L(beta) = coth beta - 1/beta = r,   a = beta/(3 r),
/// and a_0 = a at rest. The chains lock at r = 1.
class ArrudaBoyce : public ShearLaw<ArrudaBoyce>
{
public:
  static constexpr const char* name = "Arruda-Boyce";
  static constexpr const char* meaning =
      "eight chains with Langevin's statistics, entry `Locking stretch`";

  void declare(dealii::ParameterHandler& prm)
  {
    mu.declare(prm, "Shear modulus",
               "G(theta), that of chains without end; the initial shear modulus is a_0 G, "
               "a_0 = L^-1(r_0)/(3 r_0), r_0 = 1/lambda_L.",
               Quantity("MPa"));
    prm.add_parameter("Locking stretch", locking,
                      "lambda_L, the value of sqrt(tr C_EM/3) at which the chains are fully "
                      "extended. Default: VHB 4910, Wang, Decker, Henann and Chester (2016).",
                      dealii::Patterns::Double(1.001));
    prm.add_action("Locking stretch",
                   [this](const std::string&) { rest = Chain<double>(3., *this); });
  }

  /// Initial shear modulus in MPa.
  double shear_modulus(const double theta) const { return mu.value(theta) * rest.a; }

  template <typename Number>
  Number invariant(const Tensor3<2, Number>& F, const Number& J) const
  {
    using std::log;
    const Chain<Number> chain(contract(F, F), *this);
    return 2. * (locking * locking * (chain.energy - rest.energy) - rest.a * log(J));
  }

  template <typename Number>
  Tensor3<2, Number> half_gradient(const Tensor3<2, Number>& F, const Kinematics<Number>& kin) const
  {
    return Chain<Number>(contract(F, F), *this).a * F - rest.a * kin.G;
  }

  /// dW_iJ/dF_kL = G (a d_ik d_JL + a' F_iJ F_kL + a_0 G_iL G_kJ), a' = 2 da/d(F : F).
  template <typename Number>
  Tensor3<4, Number> second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                            const Number& theta) const
  {
    const Chain<Number> chain(contract(F, F), *this);
    const Number modulus = mu.value(theta), diagonal = modulus * chain.a,
                 slope = modulus * chain.slope(), volume = modulus * rest.a;
    Tensor3<4, Number> W_FF;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J) {
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int L = 0; L < 3; ++L)
            W_FF[i][J][k][L] = slope * F[i][J] * F[k][L] + volume * kin.G[i][L] * kin.G[k][J];
        W_FF[i][J][i][J] += diagonal;
      }
    return W_FF;
  }

private:
  /// A chain at an F : F.
  template <typename Number>
  struct Chain {
    Chain(const Number& F_F, const ArrudaBoyce& law) : F_F(F_F)
    {
      using std::sqrt;
      const Number r = sqrt(Number(F_F / 3.)) / law.locking;
      beta = inverse_langevin(r);
      energy = r * beta - Langevin<Number>(beta).log_shc;
      a = beta / (3. * r);
    }

    /// a' = (dbeta/dr - beta/r)/(3 F : F).
    Number slope() const { return (1. / Langevin<Number>(beta).slope - 3. * a) / (3. * F_F); }

    Number F_F, beta, energy, a;
  };

  double locking = 5.99;
  Chain<double> rest{3., *this};
};

} // namespace thelma
