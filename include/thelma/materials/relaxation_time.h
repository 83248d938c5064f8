#pragma once

#include <thelma/base/lanes.h>
#include <thelma/base/option_names.h>
#include <thelma/base/quantity.h>
#include <thelma/materials/temperature_law.h>

#include <cmath>

namespace thelma
{

/// A relaxation time tau(theta): a TemperatureLaw times a shift a_T(theta) that is 1 at theta_r
/// (theory.md, eq. 47),
///   Arrhenius:  ln a_T = E_a/R (1/theta - 1/theta_r),
///   WLF:        log10 a_T = -C_1 (theta - theta_r)/(C_2 + theta - theta_r).
class RelaxationTime
{
public:
  void declare(dealii::ParameterHandler& prm)
  {
    law.declare(prm, "Relaxation time",
                "tau(theta), in which the stress falls to 1/e at fixed deformation. Outside time "
                "the branch has relaxed unless Stepping/Static states says otherwise.",
                Quantity("s"));
    OptionNames<Shift>(
        {{"none", Shift::none}, {"Arrhenius", Shift::Arrhenius}, {"WLF", Shift::WLF}})
        .declare(prm, "Shift", shift,
                 "Factor a_T of the relaxation time: `none`: 1; `Arrhenius`: exp(Ea/R (1/theta - "
                 "1/theta_r)); `WLF`: 10^(-C1 (theta - theta_r)/(C2 + theta - theta_r)).");
    prm.add_parameter("Activation energy", activation_energy, "Ea of the Arrhenius shift in J/mol.",
                      dealii::Patterns::Double(0.));
    prm.add_parameter("WLF constants", wlf, "C1 and C2 (K) of the WLF shift.",
                      dealii::Patterns::List(dealii::Patterns::Double(0.), 2, 2));
    add_quantity(prm, "Shift temperature", theta_r, "theta_r, at which the shift is 1.",
                 Quantity("K", 1., 1e4));
  }

  std::string table_defect(const double theta) const { return law.table_defect(theta); }

  /// No number where there is none: where the law is not positive, or below the range of WLF.
  template <typename Number>
  Number value(const Number& theta) const
  {
    using std::exp;
    const Number tau = positive(law.value(theta));
    return shift == Shift::none ? tau : Number(tau * exp(ln_shift(theta)));
  }

private:
  enum class Shift { none, Arrhenius, WLF };

  template <typename Number>
  Number ln_shift(const Number& theta) const
  {
    if (shift == Shift::Arrhenius)
      return activation_energy / gas_constant * (1. / theta - 1. / theta_r);
    const Number below = wlf[1] + theta - theta_r;
    return -ln_10 * wlf[0] * (theta - theta_r) / positive(below);
  }

  static constexpr double gas_constant = 8.31446261815324; ///< J/(mol K)
  static constexpr double ln_10 = 2.302585092994046;

  TemperatureLaw law{{6.56}}; ///< s
  Shift shift = Shift::none;
  double activation_energy = 50e3; ///< J/mol
  std::vector<double> wlf{17.44, 51.6};
  double theta_r = 293.; ///< K
};

} // namespace thelma
