#pragma once

#include <thelma/elements/contractions.h>
#include <thelma/elements/formulation.h>

#include <algorithm>

namespace thelma
{

/// The state at one point of a cell, for whatever looks at points without assembling.
template <int dim>
PointState<> point_state(const CellView<dim>& view, const Gradients<dim>& gradients)
{
  const unsigned int n_c = view.cell.n_components;
  PointState<> state;
  for (unsigned int i = 0; i < 3; ++i)
    state.F[i][i] = 1.;
  state.theta = view.has_temperature ? 0. : view.theta;
  for (unsigned int a = 0; a < gradients.n_nodes; ++a) {
    const double* x = view.x + a * n_c;
    for (int J = 0; J < dim; ++J) {
      for (int i = 0; i < dim; ++i)
        state.F[axis<dim>(i)][axis<dim>(J)] += x[i] * gradients.g[J][a];
      if (view.cell.has_potential)
        state.E[axis<dim>(J)] -= x[dim] * gradients.g[J][a];
    }
    if (view.has_temperature)
      state.theta += x[n_c - 1] * gradients.N[a];
  }
  return state;
}

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
};

/// The volumetric energy alone.
struct VolumetricOnly {
  static constexpr bool conducts = false;

  template <typename Derivatives>
  void add(const Material& material, const PointState<>& state, const Kinematics<>& kin,
           unsigned int, Derivatives& d) const
  {
    add_volumetric(kin, material.thermal.volumetric(kin.J, state.theta), d);
  }
};

/// Add the integral of @p part over one cell to its residual or tangent.
template <typename Fields, typename Part>
void integrate_fields(const Integration<Fields::dim>& rule, const CellView<Fields::dim>& view,
                      const Part& part, const bool with_tangent, CellResult& result)
{
  const Material& material = *view.cell.material;
  const auto* geometry = rule.of_cell(view.index);
  for (unsigned int q = 0; q < rule.basis().n_points; ++q) {
    const Gradients<Fields::dim> gradients(rule.basis(), q, geometry[q]);
    double gradient[Fields::n][Fields::dim];
    const double last = gradients.template interpolate<Fields::n>(view.x, gradient);
    const PointInput input =
        point_input<Fields>(gradient, Fields::has_temperature ? last : view.theta);
    const Kinematics<> kin(input.state.F);
    result.min_det_F = std::min(result.min_det_F, kin.J);
    if (!(kin.J > 0.))
      return;

    PointSystem<Fields> system{};
    if constexpr (Part::conducts && Fields::has_temperature)
      add_heat_flux(material.thermal.heat_flux(kin, input.grad_theta), system);
    if (with_tangent) {
      SecondDerivatives<> d;
      part.add(material, input.state, kin, q, d);
      add_moduli(d, system);
      add_tangent(gradients, system, geometry[q].JxW, result.tangent.data());
    } else {
      FirstDerivatives<> d;
      part.add(material, input.state, kin, q, d);
      add_fluxes(d, system);
      add_residual(gradients, system, geometry[q].JxW, result.residual.data());
    }
  }
}

/// integrate_fields() for whatever fields the cell has.
template <typename Part, int dim>
void integrate(const Integration<dim>& rule, const CellView<dim>& view, const Part& part,
               const bool with_tangent, CellResult& result)
{
  const bool potential = view.cell.has_potential, temperature = view.has_temperature;
  if (potential && temperature)
    integrate_fields<Components<dim, true, true>>(rule, view, part, with_tangent, result);
  else if (potential)
    integrate_fields<Components<dim, true, false>>(rule, view, part, with_tangent, result);
  else if (temperature)
    integrate_fields<Components<dim, false, true>>(rule, view, part, with_tangent, result);
  else
    integrate_fields<Components<dim, false, false>>(rule, view, part, with_tangent, result);
}

} // namespace thelma
