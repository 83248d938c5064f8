#pragma once

#include <thelma/elements/energy_terms.h>
#include <thelma/elements/structural_heat.h>

#include <algorithm>

namespace thelma
{

/// Add the integral of @p term over one cell to its residual or tangent.
template <typename Fields, typename EnergyTerm>
void integrate_fields(const CellPoints<Fields::dim>& points, const CellView<Fields::dim>& view,
                      const EnergyTerm& term, const bool with_tangent, CellResult& result)
{
  const Material& material = *view.cell.material;
  std::array<PointFluxes<Fields>, CellPoints<Fields::dim>::max_batches> fluxes;
  for (unsigned int k = 0; k < points.n_batches(); ++k) {
    const unsigned int q = k * Lanes::n;
    const PointInput<Lanes>& input = points.input[k];
    const Kinematics<Lanes>& kin = points.kinematics[k];
    Lanes weights(0.);
    for (unsigned int lane = 0; lane < Lanes::n && q + lane < points.n_points; ++lane)
      weights.set(lane, points.geometry[q + lane].JxW);
    if constexpr (Fields::has_temperature || PointFluxes<Fields>::has_gaps)
      fluxes[k].clear();
    if constexpr (Fields::has_temperature) {
      if constexpr (EnergyTerm::conducts)
        set_heat_flux(material.thermal.heat_flux(kin, input.grad_theta), weights, fluxes[k]);
    }
    if constexpr (Fields::has_deformation) {
      if (with_tangent) {
        SecondDerivatives<Lanes> d{};
        term.add(material, input.state, kin, q, d);
        set_moduli(d, weights, fluxes[k]);
      } else {
        FirstDerivatives<Lanes> d{};
        term.add(material, input.state, kin, q, d);
        set_fluxes(d, weights, fluxes[k]);
      }
    }
  }
  const unsigned int n_c = view.cell.n_components;
  const CellComponents components{
      Fields::has_deformation ? 0 : view.cell.component(Field::temperature), n_c};
  if (with_tangent)
    add_tangent(points.gradients.data(), fluxes.data(), points.n_points, components, result.blocks);
  else
    add_residual(points.gradients.data(), fluxes.data(), points.n_points, components,
                 result.residual.data());
}

/// integrate_fields() of a cell with these fields, in the plane, in space or around an axis.
template <bool with_potential, bool with_temperature, typename EnergyTerm, int dim>
void integrate_cell(const CellPoints<dim>& points, const CellView<dim>& view,
                    const EnergyTerm& term, const bool with_tangent, CellResult& result)
{
  if constexpr (dim == 2)
    if (points.gradients[0].is_axisymmetric)
      return integrate_fields<Components<dim, with_potential, with_temperature, true>>(
          points, view, term, with_tangent, result);
  integrate_fields<Components<dim, with_potential, with_temperature>>(points, view, term,
                                                                      with_tangent, result);
}

/// integrate_cell() for whatever fields are solved for, and the structural heat; nothing where
/// det F is not positive.
template <typename EnergyTerm, int dim>
void integrate(const CellPoints<dim>& points, const CellView<dim>& view, const EnergyTerm& term,
               const bool with_tangent, CellResult& result)
{
  result.min_det_F = std::min(result.min_det_F, points.min_det_F);
  if (!(points.min_det_F > 0.))
    return;
  const bool potential = view.cell.has_potential, temperature = view.solves_temperature();
  if constexpr (EnergyTerm::conducts)
    if (temperature && view.history)
      add_structural_heat(points, view, term, with_tangent, result);
  if (!view.solves_deformation()) {
    if constexpr (EnergyTerm::conducts)
      integrate_fields<TemperatureOnly<dim>>(points, view, term, with_tangent, result);
  } else if (potential && temperature)
    integrate_cell<true, true>(points, view, term, with_tangent, result);
  else if (potential)
    integrate_cell<true, false>(points, view, term, with_tangent, result);
  else if (temperature)
    integrate_cell<false, true>(points, view, term, with_tangent, result);
  else
    integrate_cell<false, false>(points, view, term, with_tangent, result);
}

} // namespace thelma
