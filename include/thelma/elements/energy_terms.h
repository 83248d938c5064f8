#pragma once

#include <thelma/materials/material.h>

/// The terms of the energy, each of which a formulation integrates by the rule of its choice: what
/// one adds to the derivatives at point q, or at as many points from q on as the number type has
/// lanes.
namespace thelma
{

/// Everything the material has.
struct WholeEnergy {
  static constexpr bool conducts = true;

  template <typename Number, typename Derivatives>
  void add(const Material& material, const PointState<Number>& state, const Kinematics<Number>& kin,
           unsigned int, Derivatives& d) const
  {
    material.evaluate(state, d);
    add_volumetric(kin, material.thermal.volumetric(kin.J, state.theta), d);
  }

  void add_entropy_rate(const Material& material, const PointState<>& state,
                        const PointRates& rates, EntropyRate& out) const
  {
    material.add_entropy_rate(state, rates, out);
    add_volumetric_entropy_rate(material.thermal, state, rates, out);
  }
};

/// Everything but the volumetric energy.
struct WithoutVolumetric {
  static constexpr bool conducts = true;

  template <typename Number, typename Derivatives>
  void add(const Material& material, const PointState<Number>& state, const Kinematics<Number>&,
           unsigned int, Derivatives& d) const
  {
    material.evaluate(state, d);
  }

  void add_entropy_rate(const Material& material, const PointState<>& state,
                        const PointRates& rates, EntropyRate& out) const
  {
    material.add_entropy_rate(state, rates, out);
  }
};

} // namespace thelma
