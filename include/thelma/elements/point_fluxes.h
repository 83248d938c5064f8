#pragma once

#include <thelma/base/axes.h>
#include <thelma/materials/material.h>

namespace thelma
{

/// Which components a cell has and what they mean, and how many directions they have gradients in:
/// in a body of @p revolution also around its axis.
template <int dimension, bool with_potential, bool with_temperature, bool revolution = false>
struct Components {
  static constexpr int dim = dimension, n_directions = dim + (revolution ? 1 : 0);
  static constexpr bool has_deformation = true, has_potential = with_potential,
                        has_temperature = with_temperature;
  static constexpr int potential = dim;
  static constexpr int temperature = dim + (with_potential ? 1 : 0);
  static constexpr int n = temperature + (with_temperature ? 1 : 0);
};

/// The temperature alone, the last component of its cell.
template <int dimension>
struct TemperatureOnly {
  static constexpr int dim = dimension, n_directions = dim;
  static constexpr bool has_deformation = false, has_potential = false, has_temperature = true;
  static constexpr int temperature = 0, n = 1;
};

/// The fluxes at some points, one in each lane, and their moduli, as the cell sees them: its n_c
/// components (u_1 .. u_dim, phi, theta) have fluxes S = [P; D; -Q], so that a cell's residual is
/// R_ac = sum_J S_cJ dN_a/dX_J whatever the fields.
template <typename Fields>
struct PointFluxes {
  static constexpr int n_c = Fields::n, n_J = Fields::n_directions;

  Lanes S[n_c][n_J];
  /// dS_cJ/d(gradient of component d)_L, stored [c][J][L][d].
  Lanes M[n_c][n_J][n_J][n_c];
  /// dS_cJ/dtheta.
  Lanes m[n_c][n_J];

  /// Only u_1 has a gradient around an axis; the numbers of the others there are zero.
  static constexpr bool has_gaps = Fields::has_deformation && n_J > Fields::dim;

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
  for (int J = 0; J < Fields::n_directions; ++J)
    for (int i = 0; i < dim; ++i)
      if (stretches<dim>(i, J))
        fluxes.S[i][J] = w * d.P[row_of_F<dim>(i, J)][axis<dim>(J)];
  if constexpr (Fields::has_potential)
    for (int J = 0; J < dim; ++J)
      fluxes.S[Fields::potential][J] = w * d.D[axis<dim>(J)];
}

/// Those of the displacement @p i along @p J, differentiated, times @p w.
template <typename Fields>
void set_moduli_of(const SecondDerivatives<Lanes>& d, const Lanes& w, const int i, const int J,
                   PointFluxes<Fields>& fluxes)
{
  constexpr int dim = Fields::dim;
  const int xi = row_of_F<dim>(i, J), xJ = axis<dim>(J);
  for (int L = 0; L < Fields::n_directions; ++L)
    for (int k = 0; k < dim; ++k)
      if (stretches<dim>(k, L))
        fluxes.M[i][J][L][k] = w * d.dP_dF[xi][xJ][row_of_F<dim>(k, L)][axis<dim>(L)];
  if constexpr (Fields::has_potential)
    for (int L = 0; L < dim; ++L) { // E = -grad phi and dD/dF = -(dP/dE)^T
      const Lanes change = -w * d.dP_dE[xi][xJ][axis<dim>(L)];
      fluxes.M[i][J][L][Fields::potential] = change;
      fluxes.M[Fields::potential][L][J][i] = change;
    }
  if constexpr (Fields::has_temperature)
    fluxes.m[i][J] = w * d.dP_dtheta[xi][xJ];
}

/// Their derivatives times @p w.
template <typename Fields>
void set_moduli(const SecondDerivatives<Lanes>& d, const Lanes& w, PointFluxes<Fields>& fluxes)
{
  constexpr int dim = Fields::dim;
  for (int J = 0; J < Fields::n_directions; ++J)
    for (int i = 0; i < dim; ++i)
      if (stretches<dim>(i, J))
        set_moduli_of(d, w, i, J, fluxes);
  if constexpr (Fields::has_potential)
    for (int J = 0; J < dim; ++J) {
      for (int L = 0; L < dim; ++L)
        fluxes.M[Fields::potential][J][L][Fields::potential] =
            -w * d.dD_dE[axis<dim>(J)][axis<dim>(L)];
      if constexpr (Fields::has_temperature)
        fluxes.m[Fields::potential][J] = w * d.dD_dtheta[axis<dim>(J)];
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
    for (int L = 0; L < dim; ++L)
      fluxes.M[theta][J][L][theta] = -w * heat.dQ_dgrad[xJ][axis<dim>(L)];
    if constexpr (Fields::has_deformation)
      for (int L = 0; L < Fields::n_directions; ++L)
        for (int k = 0; k < dim; ++k)
          if (stretches<dim>(k, L))
            fluxes.M[theta][J][L][k] = -w * heat.dQ_dF[xJ][row_of_F<dim>(k, L)][axis<dim>(L)];
  }
}

} // namespace thelma
