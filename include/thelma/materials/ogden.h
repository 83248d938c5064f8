#pragma once

#include <thelma/materials/divided_exp.h>
#include <thelma/materials/principal_frame.h>
#include <thelma/materials/temperature_law.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace thelma
{

/// Ogden's powers of the principal stretches (theory.md, eq. 10), without their volumetric energy:
///   W = t(theta) sum_p mu_p (sum_a (lambda_a^alpha_p - 1)/alpha_p - ln J),
///   W_F = t (2 F f(C) - sum_p mu_p F^{-T}),   f(c) = sum_p mu_p/2 c^q_p,   q = alpha/2 - 1.
/// The derivatives of f(C) are divided differences of f at the squared stretches c_a, which are
/// exact where stretches are equal, or nearly.
class Ogden
{
public:
  static constexpr const char* name = "Ogden";
  static constexpr const char* meaning = "powers of the principal stretches, entry `Ogden terms`";

  void declare(dealii::ParameterHandler& prm)
  {
    using namespace dealii::Patterns;
    const Quantity unit("MPa");
    const Map pattern(Double(), unit, 1, most_terms);
    prm.declare_entry("Ogden terms", "1.3: 0.63, 5: 0.0012, -2: -0.01", pattern,
                      "`alpha_1: mu_1, alpha_2: mu_2`, ... as in W = sum mu_p/alpha_p "
                      "(lambda_1^alpha_p + lambda_2^alpha_p + lambda_3^alpha_p - 3). Default: an "
                      "example; take those of a fit to your own tests." +
                          unit.unit_sentence());
    prm.add_action("Ogden terms", [this, pattern](const std::string& text) {
      using Moduli = std::map<double, double>;
      terms.clear();
      for (const auto& [alpha, mu] : Tools::Convert<Moduli>::to_value(text, pattern))
        if (alpha != 0.) // whose limit is no energy
          terms.push_back({alpha, mu, alpha / 2. - 1.});
      scale();
    });
    modulus.declare(prm, "Shear modulus",
                    "mu(theta), to which all mu_p are scaled; empty: they are as given, mu = sum "
                    "mu_p alpha_p/2.",
                    unit);
    prm.add_action("Shear modulus", [this](const std::string&) { scale(); });
  }

  double shear_modulus(const double theta) const { return factor.value(theta) * initial_modulus(); }

  std::string table_defect(const double theta) const { return modulus.table_defect(theta); }

  template <typename Number>
  Number W(const Tensor3<2, Number>& F, const Number& J, const Number& theta) const
  {
    return factor.value(theta) * energy(Powers<Number>(*this, PrincipalFrame<Number>(F)), J);
  }

  template <typename Number>
  ElasticDerivatives<Number> first(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                                   const Number& theta) const
  {
    const PrincipalFrame<Number> at(F);
    const Powers<Number> powers(*this, at);
    Tensor3<2, Number> FVf;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int a = 0; a < 3; ++a)
        FVf[i][a] = powers.f[a] * at.FV[i][a];
    if constexpr (is_automatic<Number>) {
      const Tensor3<2, Number> differences = powers.differences(at);
      for (unsigned int a = 0; a < 3; ++a)
        for (const unsigned int b : {(a + 1) % 3, (a + 2) % 3})
          for (unsigned int i = 0; i < 3; ++i)
            FVf[i][a] += differences[a][b] * at.C(a, b) * at.FV[i][b];
    }
    const Number I = energy(powers, kin.J);
    const Tensor3<2, Number> I_F = 2. * FVf * dealii::transpose(at.V) - sum_of_mu() * kin.G;
    ElasticDerivatives<Number> d;
    d.W = factor.value(theta) * I;
    d.W_theta = factor.slope(theta) * I;
    d.W_thetatheta = factor.curvature(theta) * I;
    d.W_F = factor.value(theta) * I_F;
    d.W_Ftheta = factor.slope(theta) * I_F;
    return d;
  }

  /// With f_ab = f[c_a, c_b] and the columns F_a of F V and V_a of V, dW_iJ/dF_kL is t times
  ///   2 sum_ab f_ab (F_kb V_Jb F_ia V_La + F_ib F_kb V_Ja V_La)
  ///   + 2 d_ik sum_a f(c_a) V_Ja V_La + sum_p mu_p G_iL G_kJ.
  template <typename Number>
  Tensor3<4, Number> second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                            const Number& theta) const
  {
    const PrincipalFrame<Number> at(F);
    const Powers<Number> powers(*this, at);
    const Tensor3<2, Number> f_ab = powers.differences(at);
    const Number t = factor.value(theta), volume = sum_of_mu() * t;
    Tensor3<4, Number> W_FF;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int J = 0; J < 3; ++J)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int L = 0; L < 3; ++L)
            W_FF[i][J][k][L] = volume * kin.G[i][L] * kin.G[k][J];
    for (unsigned int a = 0; a < 3; ++a) {
      Tensor3<2, Number> VV, FV, f_FV, f_FF; // dyads of this a, and sums of those of b with f_ab
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int k = 0; k < 3; ++k) {
          VV[i][k] = at.V[i][a] * at.V[k][a];
          FV[i][k] = 2. * t * at.FV[i][a] * at.V[k][a];
          f_FF[i][k] = i == k ? Number(2. * t * powers.f[a]) : Number(0.);
          for (unsigned int b = 0; b < 3; ++b) {
            f_FV[i][k] += f_ab[a][b] * at.FV[i][b] * at.V[k][b];
            f_FF[i][k] += 2. * t * f_ab[a][b] * at.FV[i][b] * at.FV[k][b];
          }
        }
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J)
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int L = 0; L < 3; ++L)
              W_FF[i][J][k][L] += f_FV[k][J] * FV[i][L] + f_FF[i][k] * VV[J][L];
    }
    if constexpr (is_automatic<Number>)
      add_turning(at, f_ab, t, W_FF);
    return W_FF;
  }

private:
  static constexpr unsigned int most_terms = 10;

  struct Term {
    double alpha, mu, q; ///< mu in MPa; q = alpha/2 - 1
  };

  /// Powers of the principal stretches: lambda^q of each term, the energy without ln J, and f(c_a).
  template <typename Number>
  struct Powers {
    Powers(const Ogden& law, const PrincipalFrame<Number>& at) : law(law)
    {
      using std::exp;
      for (std::size_t p = 0; p < law.terms.size(); ++p) {
        const auto& [alpha, mu, q] = law.terms[p];
        for (unsigned int a = 0; a < 3; ++a) {
          roots[p][a] = exp(q * at.log_stretch[a]);
          const Number power = roots[p][a] * roots[p][a];
          energy += mu / alpha * (power * at.square[a] - 1.);
          f[a] += mu / 2. * power;
        }
      }
    }

    /// f[c_a, c_b]: of c^q = e^{2 q ln lambda}, over that of c.
    Tensor3<2, Number> differences(const PrincipalFrame<Number>& at) const
    {
      using std::sqrt;
      Tensor3<2, Number> result;
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b <= a; ++b) {
          const Number h = at.log_stretch[a] - at.log_stretch[b];
          Number sum = 0.;
          for (std::size_t p = 0; p < law.terms.size(); ++p) {
            const auto& [alpha, mu, q] = law.terms[p];
            sum += mu / 2. * q * exp_difference(Number(q * h), roots[p][a], roots[p][b]);
          }
          result[a][b] =
              sum / exp_difference(h, Number(sqrt(at.square[a])), Number(sqrt(at.square[b])));
          result[b][a] = result[a][b];
        }
      return result;
    }

    const Ogden& law;
    std::array<Tensor3<1, Number>, most_terms> roots;
    Number energy = 0.;
    Tensor3<1, Number> f;
  };

  /// f[c_a, c_b, c_c], from divided differences of c^q = e^{q x} and of c = e^x by x = ln c.
  template <typename Number>
  Tensor3<3> second_differences(const PrincipalFrame<Number>& at,
                                const Tensor3<2, Number>& f_ab) const
  {
    Tensor3<1> x;
    for (unsigned int a = 0; a < 3; ++a)
      x[a] = 2. * at.log_stretch[a].val();
    const auto of_exp = [&x](const unsigned int a, const unsigned int b) {
      return exp_difference((x[a] - x[b]) / 2., std::exp(x[a] / 2.), std::exp(x[b] / 2.));
    };
    Tensor3<3> f;
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b <= a; ++b)
        for (unsigned int c = 0; c <= b; ++c) {
          double sum = -f_ab[a][b].val() * exp_second_difference(x[a], x[b], x[c]);
          for (const auto& [alpha, mu, q] : terms)
            sum += mu / 2. * q * q * exp_second_difference(q * x[a], q * x[b], q * x[c]);
          f[a][b][c] = sum / (of_exp(b, c) * of_exp(a, c));
          f[a][c][b] = f[b][a][c] = f[b][c][a] = f[c][a][b] = f[c][b][a] = f[a][b][c];
        }
    return f;
  }

  /// What the derivatives of C beside its diagonal add to W_FF.
  template <typename Number>
  void add_turning(const PrincipalFrame<Number>& at, const Tensor3<2, Number>& f_ab,
                   const Number& t, Tensor3<4, Number>& W_FF) const
  {
    const Tensor3<3> f = second_differences(at, f_ab);
    const Tensor3<2, Number>& FV = at.FV;
    Tensor3<2, Number> C; // without its diagonal
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        C[a][b] = a == b ? Number(0.) : at.C(a, b);
    for (unsigned int a = 0; a < 3; ++a)
      for (unsigned int b = 0; b < 3; ++b)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int k = 0; k < 3; ++k) {
            Number block = i == k ? Number(f_ab[a][b] * C[a][b]) : Number(0.);
            for (unsigned int c = 0; c < 3; ++c) {
              block += f[a][b][c] * (FV[i][c] * (C[c][b] * FV[k][a] + C[b][a] * FV[k][c]) +
                                     FV[i][b] * C[c][a] * FV[k][c]);
              for (unsigned int e = 0; e < 3 && a == b; ++e)
                block += f[a][c][e] * FV[i][c] * C[c][e] * FV[k][e];
            }
            block *= 2. * t;
            for (unsigned int J = 0; J < 3; ++J)
              for (unsigned int L = 0; L < 3; ++L)
                W_FF[i][J][k][L] += at.V[J][a] * at.V[L][b] * block;
          }
  }

  template <typename Number>
  Number energy(const Powers<Number>& powers, const Number& J) const
  {
    using std::log;
    return powers.energy - sum_of_mu() * log(J);
  }

  /// Of the terms as given, in MPa.
  double initial_modulus() const
  {
    double sum = 0.;
    for (const Term& term : terms)
      sum += term.mu * term.alpha / 2.;
    return sum;
  }

  void scale()
  {
    factor = modulus.empty() ? TemperatureLaw({1.}) : modulus.times(1. / initial_modulus());
  }

  double sum_of_mu() const
  {
    double sum = 0.;
    for (const Term& term : terms)
      sum += term.mu;
    return sum;
  }

  std::vector<Term> terms;
  TemperatureLaw modulus{{}};  ///< mu(theta) in MPa, or nothing
  TemperatureLaw factor{{1.}}; ///< t(theta)
};

} // namespace thelma
