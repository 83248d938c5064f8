#pragma once

#include <thelma/elements/cell_points.h>

#include <array>
#include <cmath>
#include <vector>

/// Heat that deformation and field make: theta h N_a in the heat balance, with the rate of entropy
/// h of theory.md, eqs. 35 and 38. The capacity is elsewhere (HeatStorage).
namespace thelma
{

/// Subtract the rate of what is dissipated over theta from h, and let the derivatives of entropy
/// count what flow makes of the internal variables (theory.md, eqs. 51, 52).
inline void add_flow(const Material& material, const PointState<>& state, const CellMemory& memory,
                     const unsigned int q, const Rates& rates, EntropyRate& out)
{
  const double *old = memory.accepted(0, q), *older = memory.accepted(1, q);
  const FlowHeat flow = material.flow_heat(state, old);
  const double before =
      rates.n_past > 1 && older ? material.dissipated(older, old).energy : 0.; // the last step
  const double dissipation =
      rates.of(0., [&](const std::size_t k) { return -flow.dissipated - (k == 0 ? 0. : before); });
  SecondDerivatives<> without{};
  material.evaluate(state, without);
  const double theta = state.theta, per_time = rates.weights[0];
  out.h -= dissipation / theta;
  out.d_dF -= per_time / theta * flow.dD_dF;
  out.d_dFdot += flow.deta_dF + without.dP_dtheta;
  out.d_dtheta += per_time * (flow.deta_dtheta - without.deta_dtheta) -
                  (per_time * flow.dD_dtheta - dissipation / theta) / theta;
}

/// What a point remembered in an accepted state, as the step that has come to its end there.
inline PointHistory<> accepted_history(const Material& material, const CellMemory& memory,
                                       const std::size_t ago, const unsigned int q,
                                       std::vector<double>& step)
{
  if (!memory.steps || material.n_history() == 0)
    return {};
  step.resize(material.n_step());
  material.begin_step({}, memory.accepted(ago, q), nullptr, step.data());
  return {step.data()};
}

/// h at one point; @p past(k) is the state there k + 1 accepted states ago.
template <typename EnergyTerm, typename Past>
EntropyRate entropy_rate(const EnergyTerm& term, const Material& material,
                         const PointState<>& state, const Past& past, const CellMemory& memory,
                         const unsigned int q, const Rates& rates)
{
  EntropyRate out;
  if (rates.heat == StructuralHeat::power) {
    PointRates motion;
    for (unsigned int i = 0; i < 3; ++i) {
      for (unsigned int J = 0; J < 3; ++J)
        motion.F[i][J] =
            rates.of(state.F[i][J], [&](const std::size_t k) { return past(k).F[i][J]; });
      motion.E[i] = rates.of(state.E[i], [&](const std::size_t k) { return past(k).E[i]; });
    }
    term.add_entropy_rate(material, state, motion, out);
    return out;
  }
  const auto eta = [&](const PointState<>& s) {
    FirstDerivatives<> d{};
    term.add(material, s, Kinematics<>(s.F), q, d);
    return material.thermal.coupling_entropy(s.theta, d.eta);
  };
  out.h = rates.of(eta(state), [&](const std::size_t k) { return eta(past(k)); });
  SecondDerivatives<> d{};
  term.add(material, state, Kinematics<>(state.F), q, d);
  out.d_dFdot = -1. * d.dP_dtheta;
  out.d_dEdot = d.dD_dtheta;
  out.d_dtheta = rates.weights[0] *
                 (d.deta_dtheta - (EnergyTerm::conducts ? material.thermal.c / state.theta : 0.));
  if constexpr (EnergyTerm::conducts)
    if (!state.history.is_relaxed() && material.n_history() > 0)
      add_flow(material, state, memory, q, rates, out);
  return out;
}

/// Add theta h N_a, or its derivatives, integrated over the cell.
template <int dim, typename EnergyTerm>
void add_structural_heat(const CellPoints<dim>& points, const CellView<dim>& view,
                         const EnergyTerm& term, const bool with_tangent, CellResult& result)
{
  constexpr unsigned int length = Gradients<dim>::length;
  const Rates& rates = view.history->rates;
  const unsigned int n_nodes = points.gradients[0].n_nodes, stride = points.gradients[0].stride;
  const int n_c = view.cell.n_components, heat = view.cell.component(Field::temperature);
  std::array<NodalValues<dim>, 2> past{
      {{view.history->x[0], n_nodes, view.cell.n_components},
       {view.history->x[rates.n_past - 1], n_nodes, view.cell.n_components}}};

  alignas(64) std::array<std::array<double, CellPoints<dim>::max * length>, dim + 2> T;
  std::array<const double*, CellPoints<dim>::max> N;
  std::array<std::vector<double>, 2> steps;
  for (unsigned int q = 0; q < points.n_points; ++q) {
    const PointState<> state = points.state(q);
    const Gradients<dim>& gradients = points.gradients[q];
    const double w = points.geometry[q].JxW, theta = state.theta;
    std::array<PointState<>, 2> before;
    for (std::size_t k = 0; k < rates.n_past; ++k) {
      before[k] = point_input(view, past[k], gradients).state;
      before[k].history = accepted_history(*view.cell.material, view.memory, k, q, steps[k]);
    }
    const EntropyRate rate = entropy_rate(
        term, *view.cell.material, state,
        [&](const std::size_t k) -> const PointState<>& { return before[k]; }, view.memory, q,
        rates);
    N[q] = gradients.N;
    if (!with_tangent) {
      for (unsigned int a = 0; a < n_nodes; ++a)
        result.residual[a * n_c + heat] += w * theta * rate.h * gradients.N[a];
      continue;
    }
    const Tensor3<2> d_dF = w * theta * (rate.d_dF + rates.weights[0] * rate.d_dFdot);
    const Tensor3<1> d_dE = w * theta * (rate.d_dE + rates.weights[0] * rate.d_dEdot);
    for (unsigned int b = 0; b < stride; ++b) {
      for (int c = 0; c < heat; ++c) {
        double sum = 0.;
        for (int L = 0; L < (c < dim ? gradients.n_directions() : dim); ++L)
          if (c >= dim)
            sum -= d_dE[axis<dim>(L)] * gradients.g[L][b];
          else if (stretches<dim>(c, L))
            sum += d_dF[row_of_F<dim>(c, L)][axis<dim>(L)] * gradients.g[L][b];
        T[c][q * stride + b] = sum;
      }
      T[heat][q * stride + b] = w * (rate.h + theta * rate.d_dtheta) * gradients.N[b];
    }
  }
  if (!with_tangent)
    return;
  for (int c = view.solves_deformation() ? 0 : heat; c < n_c; ++c)
    result.blocks.add_product(heat, c, points.n_points, N.data(), T[c].data());
}

/// Rate of entropy of the volumetric energy of a dilatation t, and its derivatives.
struct VolumetricEntropyRate {
  VolumetricEntropyRate(const Thermal& thermal, const Rates& rates, const double t,
                        const double theta, const std::array<double, 2>& t_past,
                        const std::array<double, 2>& theta_past)
  {
    if (rates.heat == StructuralHeat::power) {
      const double t_dot = rates.of(t, [&](const std::size_t k) { return t_past[k]; });
      const Volumetric<Directional> v = thermal.volumetric(moving(t, t_dot), moving(theta, 0.));
      h = -v.dp_dtheta.val() * t_dot;
      d_dt = -v.dp_dtheta.dx(0) - rates.weights[0] * v.dp_dtheta.val();
      d_dtheta = v.deta_dtheta.dx(0);
    } else {
      const Volumetric<> v = thermal.volumetric(t, theta);
      h = rates.of(v.eta, [&](const std::size_t k) {
        return thermal.volumetric(t_past[k], theta_past[k]).eta;
      });
      d_dt = -rates.weights[0] * v.dp_dtheta;
      d_dtheta = rates.weights[0] * v.deta_dtheta;
    }
  }

  double h, d_dt, d_dtheta;
};

} // namespace thelma
