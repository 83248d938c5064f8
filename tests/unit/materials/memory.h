#pragma once

#include "support.h"

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

/// A point that remembers, for the tests of viscoelastic branches.
namespace thelma::material_tests
{

using Viscous = PaperMaterial;

constexpr double modulus = 0.03, relaxation = 2.; // MPa, s

/// A material with one branch.
inline std::unique_ptr<Viscous> viscous()
{
  return material_with<Viscous>(
      "subsection Branch 1\n set Modulus = 0.03\n set Relaxation time = 2\nend", 1);
}

inline Tensor3<2> deviator(const Tensor3<2>& b)
{
  return b - dealii::trace(b) / 3. * Tensor3<2>(dealii::unit_symmetric_tensor<3>());
}

/// J^{-2/3} F F^T.
inline Tensor3<2> isochoric(const Tensor3<2>& F)
{
  return std::pow(dealii::determinant(F), -2. / 3.) * (F * dealii::transpose(F));
}

/// What a point of the material with one branch remembers.
class Memory
{
public:
  explicit Memory(const Material& material) : material(material), old(material.n_history())
  {
    std::vector<double> at_rest(material.n_step());
    material.begin_step({}, nullptr, nullptr, at_rest.data());
    PointState<> rest{Tensor3<2>(dealii::unit_symmetric_tensor<3>()), Tensor3<1>(), 293., {}};
    rest.history = {at_rest.data()};
    material.update_history(rest, old.data());
  }

  /// At F, so much later, by differences of this order; until the next is asked for.
  PointState<> state(const Tensor3<2>& F, const double dt, const unsigned int order = 2)
  {
    step_numbers.resize(material.n_step());
    if (dt == std::numeric_limits<double>::infinity())
      return {F, Tensor3<1>({2., -1., 3.}), 293., {}};
    times = {dt, dt_before, order};
    material.begin_step(times, old.data(), older.empty() ? nullptr : older.data(),
                        step_numbers.data());
    return {F, Tensor3<1>({2., -1., 3.}), 293., {step_numbers.data()}};
  }

  /// Go there. What the step has done wrong, by its own estimate.
  double step(const Tensor3<2>& F, const double dt, const unsigned int order = 2)
  {
    return accept(state(F, dt, order));
  }

  double accept(const PointState<>& there)
  {
    std::vector<double> now(material.n_history());
    material.update_history(there, now.data());
    const double error =
        there.history.is_relaxed()
            ? 0.
            : material.step_error(times, old.data(), older.empty() ? nullptr : older.data(),
                                  now.data());
    older = old;
    old = now;
    dt_before = times.dt;
    return error;
  }

  /// The numbers remembered of the last state and, unless it is the first, of the one before.
  const double* now() const { return old.data(); }
  const double* before() const { return older.data(); }

  Tensor3<2> C_v() const { return symmetric(now() + StrainHistory::n); }

private:
  const Material& material;
  std::vector<double> old, older, step_numbers;
  StepTimes times;
  double dt_before = 0.;
};

/// C_v while F follows a path, by the classical Runge-Kutta method in n steps.
template <typename Path>
Tensor3<2> exact_C_v(const Path& path, const Tensor3<2>& start, const double end,
                     const unsigned int n = 4000)
{
  const double h = end / n;
  const auto rate = [&](const double t, const Tensor3<2>& C_v) {
    const Tensor3<2> C = isochoric(Tensor3<2>(dealii::transpose(path(t))));
    return 1. / relaxation * (C - contract(dealii::invert(C_v), C) / 3. * C_v);
  };
  Tensor3<2> C_v = start;
  for (unsigned int i = 0; i < n; ++i) {
    const double t = i * h;
    const Tensor3<2> k1 = rate(t, C_v), k2 = rate(t + h / 2., C_v + h / 2. * k1),
                     k3 = rate(t + h / 2., C_v + h / 2. * k2), k4 = rate(t + h, C_v + h * k3);
    C_v += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
  }
  return C_v;
}

} // namespace thelma::material_tests
