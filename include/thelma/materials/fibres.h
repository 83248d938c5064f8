#pragma once

#include <thelma/base/option_names.h>
#include <thelma/materials/divided_exp.h>
#include <thelma/materials/neo_hookean.h>

#include <deal.II/base/numbers.h>

#include <string>
#include <vector>

namespace thelma
{

/// Neo-Hookean with families of fibres in a plane of the body (Holzapfel, Gasser and Ogden, J.
/// Elasticity 61 (2000) 1; theory.md, eq. 11), without its volumetric energy. Each direction a adds
///   k_1(theta)/(2 k_2) (exp(k_2 x^2) - 1),   x = <|F a|^2 - 1>,
/// nothing where it is shorter than at rest. W_F is continuous there, W_FF is not.
class Fibres
{
public:
  static constexpr const char* name = "fibres";
  static constexpr const char* meaning =
      "neo-Hookean with families of fibres, entries `Fibre angles`, `Fibre stiffness`";

  void declare(dealii::ParameterHandler& prm)
  {
    namespace Patterns = dealii::Patterns;
    matrix.declare(prm);
    stiffness.declare(prm, "Fibre stiffness", "k_1(theta) of each family.", Quantity("MPa"));
    prm.add_parameter("Fibre exponent", k_2,
                      "k_2, with which fibres stiffen exponentially; 0: they do not.",
                      Patterns::Double(0.));
    prm.add_parameter("Fibre angles", angles,
                      "Degrees from the first axis of the plane towards the second, one for each "
                      "family.",
                      Patterns::List(Patterns::Double(-180., 180.), 1, 10));
    prm.add_action("Fibre angles", [this](const std::string&) { set_directions(); });
    planes().declare(prm, "Fibre plane", plane, "Plane of the fibres in the undeformed body.");
    prm.add_action("Fibre plane", [this](const std::string&) { set_directions(); });
  }

  /// That of the matrix, in MPa.
  double shear_modulus(const double theta) const { return matrix.shear_modulus(theta); }

  std::string table_defect(const double theta) const
  {
    const std::string first = matrix.table_defect(theta);
    return first.empty() ? stiffness.table_defect(theta) : first;
  }

  template <typename Number>
  Number W(const Tensor3<2, Number>& F, const Number& J, const Number& theta) const
  {
    Number sum = 0.;
    for (const Tensor3<1>& a : directions)
      sum += Fibre<Number>(F, a, k_2).energy();
    return matrix.W(F, J, theta) + stiffness.value(theta) * sum;
  }

  template <typename Number>
  ElasticDerivatives<Number> first(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                                   const Number& theta) const
  {
    ElasticDerivatives<Number> d = matrix.first(F, kin, theta);
    for (const Tensor3<1>& a : directions) {
      const Fibre<Number> fibre(F, a, k_2);
      const Number energy = fibre.energy();
      d.W += stiffness.value(theta) * energy;
      d.W_theta += stiffness.slope(theta) * energy;
      d.W_thetatheta += stiffness.curvature(theta) * energy;
      const Number force = 2. * fibre.slope(), now = stiffness.value(theta) * force,
                   change = stiffness.slope(theta) * force;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J) {
          d.W_F[i][J] += now * fibre.Fa[i] * a[J];
          d.W_Ftheta[i][J] += change * fibre.Fa[i] * a[J];
        }
    }
    return d;
  }

  /// Each family adds k_1 (4 w'' (F a)_i (F a)_k + 2 w' d_ik) a_J a_L, with w of |F a|^2.
  template <typename Number>
  Tensor3<4, Number> second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                            const Number& theta) const
  {
    Tensor3<4, Number> W_FF = matrix.second(F, kin, theta);
    for (const Tensor3<1>& a : directions) {
      const Fibre<Number> fibre(F, a, k_2);
      const Number force = 2. * stiffness.value(theta) * fibre.slope(),
                   modulus = 4. * stiffness.value(theta) * fibre.curvature();
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int k = 0; k < 3; ++k) {
          const Number block = modulus * fibre.Fa[i] * fibre.Fa[k] + (i == k ? force : Number(0.));
          for (unsigned int J = 0; J < 3; ++J)
            for (unsigned int L = 0; L < 3; ++L)
              W_FF[i][J][k][L] += a[J] * a[L] * block;
        }
    }
    return W_FF;
  }

private:
  /// w = (exp(k_2 x^2) - 1)/(2 k_2) of a fibre, to rounding for every k_2, and its derivatives.
  template <typename Number>
  struct Fibre {
    Fibre(const Tensor3<2, Number>& F, const Tensor3<1>& a, const double k_2) : k_2(k_2)
    {
      using std::exp;
      for (unsigned int i = 0; i < 3; ++i)
        Fa[i] = F[i][0] * a[0] + F[i][1] * a[1] + F[i][2] * a[2];
      const Number stretched = contract(Fa, Fa) - 1.;
      tense = below(stretched, 0., Number(0.), Number(1.));
      x = tense * stretched;
      root = exp(k_2 / 2. * x * x);
    }

    Number energy() const
    {
      return x * x / 2. * exp_difference(Number(k_2 / 2. * x * x), root, Number(1.));
    }
    Number slope() const { return x * root * root; }
    Number curvature() const { return tense * (1. + 2. * k_2 * x * x) * root * root; }

    double k_2;
    Tensor3<1, Number> Fa;
    Number tense, x, root; ///< 1 in tension, else 0; x; exp(k_2 x^2/2)
  };

  enum class Plane { x1_x2, x1_x3, x2_x3 };

  static OptionNames<Plane> planes()
  {
    return OptionNames<Plane>(
        {{"x1-x2", Plane::x1_x2}, {"x1-x3", Plane::x1_x3}, {"x2-x3", Plane::x2_x3}});
  }

  void set_directions()
  {
    const unsigned int first = plane == Plane::x2_x3 ? 1 : 0,
                       second = plane == Plane::x1_x2 ? 1 : 2;
    directions.clear();
    for (const double angle : angles) {
      Tensor3<1> a;
      a[first] = std::cos(angle * dealii::numbers::PI / 180.);
      a[second] = std::sin(angle * dealii::numbers::PI / 180.);
      directions.push_back(a);
    }
  }

  NeoHookean matrix;
  TemperatureLaw stiffness{{0.1}}; ///< k_1 in MPa
  double k_2 = 0.;
  std::vector<double> angles{30., -30.};
  Plane plane = Plane::x1_x2;
  std::vector<Tensor3<1>> directions;
};

} // namespace thelma
