#pragma once

#include <thelma/base/expression.h>
#include <thelma/materials/invariants.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace thelma
{

/// An energy W(I_1, I_2, J, theta) of F_EM that a parameter file brings along (theory.md, eq. 12),
/// without its volumetric part; its derivatives by the four are exact (Jet).
class ExpressionLaw
{
public:
  static constexpr const char* name = "expression";
  static constexpr const char* meaning = "an energy of your own, entry `Energy`";

  void declare(dealii::ParameterHandler& prm);

  /// Of the body at rest, in MPa.
  double shear_modulus(double theta) const;

  /// Parameters are numbers.
  std::string table_defect(double /*theta*/) const { return ""; }

  template <typename Number>
  Number W(const Tensor3<2, Number>& F, const Number& J, const Number& theta) const
  {
    return energy(Invariants<Number>(F, J), theta).value;
  }

  template <typename Number>
  ElasticDerivatives<Number> first(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                                   const Number& theta) const
  {
    const Invariants<Number> at(F, kin.J);
    const Jet<Number, 4> w = energy(at, theta);
    const auto gradients = at.gradients(F, kin.G);
    ElasticDerivatives<Number> d;
    d.W = w.value;
    d.W_theta = w.first[3];
    d.W_thetatheta = w.seconds[w.second(3, 3)];
    for (unsigned int a = 0; a < 3; ++a) {
      d.W_F += w.first[a] * gradients[a];
      d.W_Ftheta += w.seconds[w.second(3, a)] * gradients[a];
    }
    return d;
  }

  template <typename Number>
  Tensor3<4, Number> second(const Tensor3<2, Number>& F, const Kinematics<Number>& kin,
                            const Number& theta) const
  {
    const Invariants<Number> at(F, kin.J);
    return at.second(energy(at, theta), F, kin.G);
  }

private:
  /// In the order of the names in read().
  template <typename Number>
  Jet<Number, 4> energy(const Invariants<Number>& at, const Number& theta) const
  {
    using D = Jet<Number, 4>;
    return formula(std::array<D, 4>{{D::variable(at.I_1, 0), D::variable(at.I_2, 1),
                                     D::variable(at.J, 2), D::variable(theta, 3)}});
  }

  void read(const std::string& text);

  Expression formula{"0", {}, {}}; ///< MPa
};

} // namespace thelma
