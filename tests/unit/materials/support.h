#pragma once

#include "sacado.h"
#include <deal.II/base/symmetric_tensor.h>

#include <thelma/materials/library.h>
#include <thelma/materials/material_list.h>

#include <gtest/gtest.h>

#include <list>
#include <map>
#include <memory>
#include <random>
#include <string>

/// What the tests of the material laws share: materials, states, errors by block.
namespace thelma::material_tests
{

/// The law of the paper.
using PaperMaterial = ComposedMaterial<NeoHookean, IdealDielectric>;

/// A state without symmetries; |E| (kV/mm) is two thirds of the field at which a free planar
/// film pulls in.
inline const PointState<> some_state{Tensor3<2>({{1.2, .3, -.1}, {-.2, .9, .2}, {.1, .15, 1.1}}),
                                     Tensor3<1>({6., -4., 9.}), 340.};

/// A material with those of the @p entries `set name = value` that it has, the others at their
/// defaults, and so many Maxwell branches.
template <class SomeMaterial>
std::unique_ptr<SomeMaterial> material_with(const std::string& entries,
                                            const unsigned int n_branches = 0)
{
  auto material = std::make_unique<SomeMaterial>();
  material->set_branches(
      Branches(std::vector<std::string>(n_branches, std::string(MaxwellBranch::name))));
  dealii::ParameterHandler prm;
  material->declare(prm);
  prm.parse_input_from_string(entries, "", true);
  return material;
}

/// A law without its volumetric energy, as an element formulation asks for it.
template <class SomeMaterial>
struct WithoutVolumetric {
  const SomeMaterial& material;

  template <typename Number>
  Number psi(const PointState<Number>& state) const
  {
    return material.psi(state);
  }

  template <typename Number>
  FirstDerivatives<Number> first(const PointState<Number>& state) const
  {
    return material.first_derivatives(state);
  }

  template <typename Number>
  SecondDerivatives<Number> second(const PointState<Number>& state) const
  {
    return material.second_derivatives(state);
  }
};

/// The whole law: what a fully integrated element sees.
template <class SomeMaterial>
struct Total {
  const SomeMaterial& material;

  template <typename Number>
  Number psi(const PointState<Number>& state) const
  {
    const Kinematics<Number> kin(state.F);
    return material.psi(state) + material.thermal.volumetric(kin.J, state.theta).psi;
  }

  template <typename Number>
  FirstDerivatives<Number> first(const PointState<Number>& state) const
  {
    return added(state, material.first_derivatives(state));
  }

  template <typename Number>
  SecondDerivatives<Number> second(const PointState<Number>& state) const
  {
    return added(state, material.second_derivatives(state));
  }

private:
  template <typename Number, class Derivatives>
  Derivatives added(const PointState<Number>& state, Derivatives out) const
  {
    const Kinematics<Number> kin(state.F);
    add_volumetric(kin, material.thermal.volumetric(kin.J, state.theta), out);
    return out;
  }
};

template <class SomeMaterial>
WithoutVolumetric<SomeMaterial> without_volumetric(const SomeMaterial& material)
{
  return {material};
}

template <class SomeMaterial>
Total<SomeMaterial> total(const SomeMaterial& material)
{
  return {material};
}

/// Random points of the range the scenes visit, and well beyond it. The seed is fixed, so that a
/// failure comes back.
class RandomStates
{
public:
  double uniform(const double low, const double high)
  {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }

  Tensor3<1> direction()
  {
    std::normal_distribution<double> normal;
    const Tensor3<1> v({normal(engine), normal(engine), normal(engine)});
    return v / v.norm();
  }

  /// Rotation about a random axis (Rodrigues).
  Tensor3<2> rotation()
  {
    const Tensor3<1> n = direction();
    const double angle = uniform(0., 2. * dealii::numbers::PI);
    const Tensor3<2> cross({{0., -n[2], n[1]}, {n[2], 0., -n[0]}, {-n[1], n[0], 0.}});
    return dealii::unit_symmetric_tensor<3>() + std::sin(angle) * cross +
           (1. - std::cos(angle)) * cross * cross;
  }

  /// det F in [0.3, 3], shape change by principal stretches up to a factor 4 apart.
  Tensor3<2> deformation()
  {
    const double ln_J = uniform(std::log(0.3), std::log(3.));
    Tensor3<1> a;
    for (unsigned int i = 0; i < 3; ++i)
      a[i] = uniform(-std::log(2.), std::log(2.));
    Tensor3<2> stretch;
    for (unsigned int i = 0; i < 3; ++i)
      stretch[i][i] = std::exp(ln_J / 3. + a[i] - (a[0] + a[1] + a[2]) / 3.);
    return rotation() * stretch * rotation();
  }

  /// A law that remembers has relaxed at another deformation, and flows for 0.1 to 100 s.
  PointHistory<> history(const Material& material)
  {
    if (material.n_history() == 0)
      return {};
    relaxed.resize(material.n_history());
    PointState<> before;
    before.F = deformation();
    before.theta = uniform(250., 400.);
    material.update_history(before, relaxed.data());
    steps.emplace_back(material.n_step());
    material.begin_step({std::pow(10., uniform(-1., 2.)), 0., 2}, relaxed.data(), nullptr,
                        steps.back().data());
    return {steps.back().data()};
  }

  /// What the state that was made last has remembered since it relaxed.
  const double* remembered() const { return relaxed.data(); }

  /// 250 to 400 K and |E| up to twice the nominal field 0.687 sqrt(mu/eps) at which a free planar
  /// film pulls in (theory.md, eq. 54).
  PointState<> next(const Material& material)
  {
    PointState<> state;
    state.F = deformation();
    state.theta = uniform(250., 400.);
    const double unit_field =
        std::sqrt(material.shear_modulus(state.theta) / material.permittivity(state.theta));
    state.E = uniform(0., 2. * 0.687) * unit_field * direction();
    state.history = history(material);
    return state;
  }

private:
  std::mt19937 engine{20240229};
  std::vector<double> relaxed;
  std::list<std::vector<double>> steps; ///< of all states, which refer to them
};

/// The largest relative error of each named block over many states:
///   |ours - exact| / max(|exact|, scale).
/// The floor is needed because a block is a sum of terms that may cancel (elastic against Maxwell
/// stress, entropy near theta_0): round-off belongs to the terms, so that it is measured by their
/// size, the @p scale of the block.
class WorstErrors
{
public:
  template <int rank>
  void add(const std::string& block, const Tensor3<rank>& ours, const Tensor3<rank>& exact,
           const double scale)
  {
    record(block, (ours - exact).norm() / std::max(exact.norm(), scale));
  }

  void add(const std::string& block, const double ours, const double exact, const double scale)
  {
    record(block, std::abs(ours - exact) / std::max(std::abs(exact), scale));
  }

  void expect_below(const double tolerance) const
  {
    EXPECT_FALSE(worst.empty());
    for (const auto& [block, error] : worst)
      EXPECT_LT(error, tolerance) << "in the block " << block;
  }

private:
  void record(const std::string& block, const double error)
  {
    double& largest = worst[block];
    // Written so that a NaN is kept.
    if (!(error <= largest))
      largest = error;
  }

  std::map<std::string, double> worst;
};

} // namespace thelma::material_tests
