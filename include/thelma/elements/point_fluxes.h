#pragma once

#include <thelma/base/axes.h>
#include <thelma/materials/material.h>

namespace thelma
{

/// Which components a cell has and what they mean.
template <int dimension, bool with_potential, bool with_temperature>
struct Components {
  static constexpr int dim = dimension;
  static constexpr bool has_deformation = true, has_potential = with_potential,
                        has_temperature = with_temperature;
  static constexpr int potential = dim;
  static constexpr int temperature = dim + (with_potential ? 1 : 0);
  static constexpr int n = temperature + (with_temperature ? 1 : 0);
};

/// The temperature alone, the last component of its cell.
template <int dimension>
struct TemperatureOnly {
  static constexpr int dim = dimension;
  static constexpr bool has_deformation = false, has_potential = false, has_temperature = true;
  static constexpr int temperature = 0, n = 1;
};

/// The fluxes at some points, one in each lane, and their moduli, as the cell sees them: its n_c
/// components (u_1 .. u_dim, phi, theta) have fluxes S = [P; D; -Q], so that a cell's residual is
/// R_ac = sum_J S_cJ dN_a/dX_J whatever the fields.
template <typename Fields>
struct PointFluxes {
  static constexpr int dim = Fields::dim, n_c = Fields::n;

  Lanes S[n_c][dim];
  /// dS_cJ/d(gradient of component d)_L, stored [c][J][L][d].
  Lanes M[n_c][dim][dim][n_c];
  /// dS_cJ/dtheta.
  Lanes m[n_c][dim];

  void clear() { *this = PointFluxes(); }
};

/// What a cell's nodal values give at a point.
template <typename Number>
struct PointInput {
  PointState<Number> state;
  Tensor3<1, Number> grad_theta;
};

/// The fluxes of the laws times the integration weights @p w.
template <typename Fields>
void set_fluxes(const FirstDerivatives<Lanes>& d, const Lanes& w, PointFluxes<Fields>& fluxes)
{
  constexpr int dim = Fields::dim;
  for (int J = 0; J < dim; ++J) {
    for (int i = 0; i < dim; ++i)
      fluxes.S[i][J] = w * d.P[axis<dim>(i)][axis<dim>(J)];
    if constexpr (Fields::has_potential)
      fluxes.S[Fields::potential][J] = w * d.D[axis<dim>(J)];
  }
}

/// Their derivatives times @p w.
template <typename Fields>
void set_moduli(const SecondDerivatives<Lanes>& d, const Lanes& w, PointFluxes<Fields>& fluxes)
{
  constexpr int dim = Fields::dim, phi = Fields::potential;
  for (int J = 0; J < dim; ++J)
    for (int L = 0; L < dim; ++L) {
      const int xJ = axis<dim>(J), xL = axis<dim>(L);
      for (int i = 0; i < dim; ++i) {
        const int xi = axis<dim>(i);
        for (int k = 0; k < dim; ++k)
          fluxes.M[i][J][L][k] = w * d.dP_dF[xi][xJ][axis<dim>(k)][xL];
        if constexpr (Fields::has_potential) { // E = -grad phi and dD/dF = -(dP/dE)^T
          fluxes.M[i][J][L][phi] = -w * d.dP_dE[xi][xJ][xL];
          fluxes.M[phi][J][L][i] = -w * d.dP_dE[xi][xL][xJ];
        }
      }
      if constexpr (Fields::has_potential)
        fluxes.M[phi][J][L][phi] = -w * d.dD_dE[xJ][xL];
    }
  if constexpr (Fields::has_temperature)
    for (int J = 0; J < dim; ++J) {
      for (int i = 0; i < dim; ++i)
        fluxes.m[i][J] = w * d.dP_dtheta[axis<dim>(i)][axis<dim>(J)];
      if constexpr (Fields::has_potential)
        fluxes.m[phi][J] = w * d.dD_dtheta[axis<dim>(J)];
    }
}

/// The heat flux and its derivatives times @p w.
template <typename Fields>
void set_heat_flux(const HeatFlux<Lanes>& heat, const Lanes& w, PointFluxes<Fields>& fluxes)
{
  constexpr int dim = Fields::dim, theta = Fields::temperature;
  for (int J = 0; J < dim; ++J) {
    const int xJ = axis<dim>(J);
    fluxes.S[theta][J] = -w * heat.Q[xJ];
    for (int L = 0; L < dim; ++L) {
      const int xL = axis<dim>(L);
      fluxes.M[theta][J][L][theta] = -w * heat.dQ_dgrad[xJ][xL];
      if constexpr (Fields::has_deformation)
        for (int k = 0; k < dim; ++k)
          fluxes.M[theta][J][L][k] = -w * heat.dQ_dF[xJ][axis<dim>(k)][xL];
    }
  }
}

} // namespace thelma
