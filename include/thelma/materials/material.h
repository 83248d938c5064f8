#pragma once

#include <thelma/materials/entropy_rate.h>
#include <thelma/materials/flow_heat.h>
#include <thelma/materials/point.h>
#include <thelma/materials/temperature_law.h>
#include <thelma/materials/thermal.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace thelma
{

class Branches;

/// Energies per reference volume in mJ/mm^3 = MPa. Inner energy is the sum of elastic, electric and
/// thermal and c (theta - theta_0); entropy that of the part here and c ln(theta/theta_0).
struct Energies {
  double elastic = 0.;  ///< (theta/theta_0) W, and what the volumetric energy adds to it
  double electric = 0.; ///< stored field energy psi_d + E.D, D.E/2 for a linear dielectric
  double thermal = 0.;  ///< psi_t + theta eta without the part of the heat capacity
  double entropy = 0.;  ///< eta without the part of the heat capacity, MPa/K

  /// Add @p w times @p other.
  void add(const double w, const Energies& other)
  {
    elastic += w * other.elastic;
    electric += w * other.electric;
    thermal += w * other.thermal;
    entropy += w * other.entropy;
  }
};

/// What the volumetric energy adds to them.
inline Energies energies(const Volumetric<>& v, const double theta)
{
  return {v.psi, 0., theta * v.eta, v.eta};
}

/// What the rest of the program knows of a material. Energies and derivatives leave the volumetric
/// energy out; the element formulation adds it by its own rule.
class Material
{
public:
  virtual ~Material() = default;

  /// Declares every entry of this material in the section @p prm stands in.
  virtual void declare(dealii::ParameterHandler& prm) = 0;

  virtual Energies energies(const PointState<>& state) const = 0;

  /// Second derivatives are zero before.
  virtual void evaluate(const PointState<>& state, FirstDerivatives<>& out) const = 0;
  virtual void evaluate(const PointState<>& state, SecondDerivatives<>& out) const = 0;
  virtual void evaluate(const PointState<Lanes>& state, FirstDerivatives<Lanes>& out) const = 0;
  virtual void evaluate(const PointState<Lanes>& state, SecondDerivatives<Lanes>& out) const = 0;

  /// Add to @p out what the material without its volumetric energy has of it.
  virtual void add_entropy_rate(const PointState<>& state, const PointRates& rates,
                                EntropyRate& out) const = 0;

  /// Let it have these branches, before it is declared.
  virtual void set_branches(Branches branches) = 0;

  /// Section and entry of a table that does not reach @p theta, and its range; empty if all do.
  virtual std::string table_defect(double theta) const = 0;

  /// What branches add to the shear modulus at once, in MPa; the entry of one that does not allow
  /// @p theta, or nothing.
  virtual double branch_modulus(double theta) const = 0;
  virtual std::string branch_defect(double theta) const = 0;

  /// What flow dissipates over a step: between two states of which a point remembers @p before and
  /// @p now; and with its derivatives over a step that ends at @p state.
  virtual Dissipated<> dissipated(const double* before, const double* now) const = 0;
  virtual FlowHeat flow_heat(const PointState<>& state, const double* before) const = 0;

  /// How many numbers a point remembers, and how many describe a step (PointHistory).
  virtual unsigned int n_history() const = 0;
  virtual unsigned int n_step() const = 0;

  /// The step from the last accepted states, of which a point remembers @p old (null: the body at
  /// rest, without time to flow) and @p older (null: there is none); the numbers at the end of a
  /// step to @p state, into @p now; and what the step has done wrong to the internal variables.
  virtual void begin_step(const StepTimes& times, const double* old, const double* older,
                          double* step) const = 0;
  virtual void update_history(const PointState<>& state, double* now) const = 0;
  virtual double step_error(const StepTimes& times, const double* old, const double* older,
                            const double* now) const = 0;

  /// Shear modulus (MPa) and permittivity (N/kV^2) of the undeformed material.
  virtual double shear_modulus(double theta) const = 0;
  virtual double permittivity(double theta) const = 0;

  std::string name; ///< of its section
  Thermal thermal;
  double density = 960.; ///< per reference volume, kg/m^3; 3M's of VHB 4910
};

/// What the volumetric energy adds to the derivatives when its J is that of @p kin:
///   P = p J G,  dP/dF = (p J + dp/dJ J^2) G x G - p J G_iL G_kJ.
template <typename Number>
void add_volumetric(const Kinematics<Number>& kin, const Volumetric<Number>& v,
                    FirstDerivatives<Number>& out)
{
  out.P += v.p * kin.J * kin.G;
  out.eta += v.eta;
}

template <typename Number>
void add_volumetric(const Kinematics<Number>& kin, const Volumetric<Number>& v,
                    SecondDerivatives<Number>& out)
{
  const Tensor3<2, Number>& G = kin.G;
  const Number pJ = v.p * kin.J, slope = pJ + v.dp_dJ * kin.J * kin.J;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int J = 0; J < 3; ++J)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int L = 0; L < 3; ++L)
          out.dP_dF[i][J][k][L] += slope * G[i][J] * G[k][L] - pJ * G[i][L] * G[k][J];
  out.dP_dtheta += v.dp_dtheta * kin.J * G;
  out.deta_dtheta += v.deta_dtheta;
}

/// The entropy rate of the volumetric energy when its J is det F.
inline void add_volumetric_entropy_rate(const Thermal& thermal, const PointState<>& state,
                                        const PointRates& rates, EntropyRate& out)
{
  const PointState<Directional> moving = along(state, rates);
  const Kinematics<Directional> kin(moving.F);
  SecondDerivatives<Directional> d{};
  d.dP_dtheta = thermal.volumetric(kin.J, moving.theta).dp_dtheta * kin.J * kin.G;
  d.deta_dtheta = thermal.volumetric(kin.J, moving.theta).deta_dtheta;
  add_entropy_rate(d, rates, out);
}

} // namespace thelma
