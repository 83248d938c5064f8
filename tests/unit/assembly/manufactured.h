#pragma once

#include "scene.h"

#include <thelma/elements/integrate.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace thelma_test
{

/// Fields over space and time, and the loads that hold them in balance (theory.md, eqs. 24a to
/// 24c): value(t) shape(X) for each component, plus a constant for the temperature.
struct ExactFields {
  /// amplitude (mean + swing sin(rate t)) times sin(k.X + shift), or times (k.X + shift) if linear.
  struct Component {
    double mean, swing, rate;
    dealii::Point<3> k;
    double shift, constant;
  };
  std::array<Component, 5> components; ///< u1, u2, u3, phi, theta
  bool linear;

  double value(const unsigned int c, const dealii::Point<3>& X, const double t) const
  {
    return components[c].constant + amplitude(c, t) * shape(c, X);
  }
  double rate(const unsigned int c, const dealii::Point<3>& X, const double t) const
  {
    return amplitude_rate(c, t) * shape(c, X);
  }
  dealii::Tensor<1, 3> gradient(const unsigned int c, const dealii::Point<3>& X,
                                const double t) const
  {
    return amplitude(c, t) * shape_gradient(c, X);
  }
  dealii::Tensor<1, 3> gradient_rate(const unsigned int c, const dealii::Point<3>& X,
                                     const double t) const
  {
    return amplitude_rate(c, t) * shape_gradient(c, X);
  }

private:
  double amplitude(const unsigned int c, const double t) const
  {
    return components[c].mean + components[c].swing * std::sin(components[c].rate * t);
  }
  double amplitude_rate(const unsigned int c, const double t) const
  {
    return components[c].swing * components[c].rate * std::cos(components[c].rate * t);
  }
  double argument(const unsigned int c, const dealii::Point<3>& X) const
  {
    return components[c].k * X + components[c].shift;
  }
  double shape(const unsigned int c, const dealii::Point<3>& X) const
  {
    return linear ? argument(c, X) : std::sin(argument(c, X));
  }
  dealii::Tensor<1, 3> shape_gradient(const unsigned int c, const dealii::Point<3>& X) const
  {
    return (linear ? 1. : std::cos(argument(c, X))) * components[c].k;
  }
};

/// Stress, electric displacement, heat flux and stored heat of the exact fields at a point.
struct ExactPoint {
  ExactPoint(const ExactFields& exact, const Material& material, const StructuralHeat heat,
             const dealii::Point<3>& X, const double t)
  {
    PointState<> state;
    PointRates rates;
    for (unsigned int i = 0; i < 3; ++i) {
      state.F[i] = exact.gradient(i, X, t);
      state.F[i][i] += 1.;
      rates.F[i] = exact.gradient_rate(i, X, t);
    }
    state.E = -exact.gradient(3, X, t);
    rates.E = -exact.gradient_rate(3, X, t);
    state.theta = exact.value(4, X, t);
    const Kinematics<> kin(state.F);
    WholeEnergy().add(material, state, kin, 0, d);
    Q = material.thermal.heat_flux(kin, exact.gradient(4, X, t)).Q;
    const double theta_dot = exact.rate(4, X, t);
    capacity = material.thermal.c * theta_dot;
    EntropyRate entropy;
    WholeEnergy().add_entropy_rate(material, state, rates, entropy);
    coupling = state.theta * entropy.h;
    if (heat == StructuralHeat::entropy) {
      SecondDerivatives<> second{};
      WholeEnergy().add(material, state, kin, 0, second);
      coupling += (state.theta * second.deta_dtheta - material.thermal.c) * theta_dot;
    }
    if (heat == StructuralHeat::none)
      coupling = 0.;
  }

  FirstDerivatives<> d{};
  Tensor3<1> Q;
  double capacity, coupling; ///< of the stored heat, MPa/s
};

/// A box whose fields follow @p exact: prescribed on its supports, electrodes and heated walls, and
/// held by loads elsewhere.
class Manufactured
{
public:
  Manufactured(const std::string& text, ExactFields fields, const StructuralHeat heat,
               const unsigned int n_points, const bool nodal_capacity)
      : scene(text, 320.), exact(std::move(fields)), heat(heat), rule(n_points),
        nodal_capacity(nodal_capacity)
  {
    scene.state.x = interpolated(0.);
    scene.system.converge_internal();
    scene.state.start();
  }

  /// March to @p end in @p n steps; the last ones of unequal length show that these may vary.
  void march(const double end, const unsigned int n, const unsigned int order)
  {
    Newton newton;
    for (unsigned int i = 1; i <= n; ++i) {
      const double s = double(i) / n, t = end * s * (1. + 0.3 * (1. - s));
      std::vector<double> times;
      for (const auto& accepted : scene.state.path())
        times.push_back(accepted.load);
      scene.state.rates = backward_differences(t, times, order);
      scene.state.rates->heat = heat;
      const BlockVector wanted = interpolated(t);
      for (const auto& line : scene.conditions.constraints().get_lines())
        if (scene.layout.dof_handler().locally_owned_dofs().is_element(line.index))
          scene.state.x(line.index) = wanted(line.index);
      scene.state.x.update_ghost_values();
      scene.system.hold_with(loads(t));
      const NewtonReport report = newton.solve(scene.system);
      ASSERT_TRUE(report.converged) << report.reason;
      scene.state.accept(t);
      time = t;
    }
  }

  /// Errors of u (mm), phi (kV) and theta (K) in the norm of L2, at the last time.
  std::array<double, 3> errors() const
  {
    std::array<double, 3> sums{};
    dealii::FEValues<3> values(scene.layout.scalar_element(), dealii::QGauss<3>(5),
                               dealii::update_values | dealii::update_quadrature_points |
                                   dealii::update_JxW_values);
    std::vector<double> x;
    for (const Cell<3>& cell : scene.layout.cells()) {
      scene.layout.gather(cell, scene.state.x, x);
      values.reinit(dealii::Triangulation<3>::active_cell_iterator(cell.iterator));
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
        for (unsigned int c = 0; c < 5; ++c) {
          double found = 0.;
          for (unsigned int a = 0; a < values.dofs_per_cell; ++a)
            found += values.shape_value(a, q) * x[a * 5 + c];
          sums[c < 3 ? 0 : c - 2] +=
              values.JxW(q) * std::pow(found - exact.value(c, values.quadrature_point(q), time), 2);
        }
    }
    for (double& sum : sums)
      sum = std::sqrt(sum);
    return sums;
  }

  TestScene<3> scene;

private:
  /// Call @p action(unknown, component, X) for each node.
  template <typename Action>
  void for_each_node(const Action& action) const
  {
    const auto& points = scene.layout.scalar_element().get_unit_support_points();
    for (const Cell<3>& cell : scene.layout.cells())
      for (unsigned int a = 0; a < points.size(); ++a) {
        const auto X = scene.layout.mapping().transform_unit_to_real_cell(cell.iterator, points[a]);
        for (unsigned int c = 0; c < 5; ++c)
          action(cell.dofs[a * 5 + c], c, X);
      }
  }

  BlockVector interpolated(const double t) const
  {
    BlockVector x = scene.layout.new_vector();
    for_each_node([&](const auto unknown, const unsigned int c, const dealii::Point<3>& X) {
      x(unknown) = exact.value(c, X, t);
    });
    x.zero_out_ghost_values();
    x.update_ghost_values();
    return x;
  }

  BlockVector loads(const double t) const
  {
    BlockVector forces = scene.layout.new_vector();
    dealii::FEValues<3> values(scene.layout.scalar_element(), dealii::QGauss<3>(rule),
                               dealii::update_values | dealii::update_gradients |
                                   dealii::update_quadrature_points | dealii::update_JxW_values);
    for (const Cell<3>& cell : scene.layout.cells()) {
      values.reinit(dealii::Triangulation<3>::active_cell_iterator(cell.iterator));
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q) {
        const ExactPoint at(exact, *cell.material, heat, values.quadrature_point(q), t);
        for (unsigned int a = 0; a < values.dofs_per_cell; ++a) {
          const auto grad = values.JxW(q) * values.shape_grad(a, q);
          for (unsigned int i = 0; i < 3; ++i)
            forces(cell.dofs[a * 5 + i]) += at.d.P[i] * grad;
          forces(cell.dofs[a * 5 + 3]) += at.d.D * grad;
          forces(cell.dofs[a * 5 + 4]) +=
              -1. * (at.Q * grad) + values.JxW(q) * values.shape_value(a, q) *
                                        (at.coupling + (nodal_capacity ? 0. : at.capacity));
        }
      }
    }
    forces.compress(dealii::VectorOperation::add);
    if (nodal_capacity) {
      BlockVector rate = scene.layout.new_vector();
      for_each_node([&](const auto unknown, const unsigned int c, const dealii::Point<3>& X) {
        rate(unknown) = c == 4 ? exact.rate(4, X, t) : 0.;
      });
      rate.zero_out_ghost_values();
      rate.scale(scene.storage.capacity());
      forces += rate;
    }
    return forces;
  }

  ExactFields exact;
  StructuralHeat heat;
  unsigned int rule;
  bool nodal_capacity;
  double time = 0.;
};

} // namespace thelma_test
