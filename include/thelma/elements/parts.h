#pragma once

#include <thelma/materials/material.h>

/// The parts of the energy that a formulation integrates, each by the rule of its choice.
namespace thelma
{

/// Everything the material has.
struct WholeEnergy {
  static constexpr bool conducts = true;

  template <typename Derivatives>
  void add(const Material& material, const PointState<>& state, const Kinematics<>& kin,
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

  template <typename Derivatives>
  void add(const Material& material, const PointState<>& state, const Kinematics<>&, unsigned int,
           Derivatives& d) const
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
