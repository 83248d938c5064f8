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

/// The point physics seen by one cell: its n_c components (u_1 .. u_dim, phi, theta) have fluxes
/// S = [P; D; -Q], so that a cell's residual is R_ac = sum_J S_cJ dN_a/dX_J whatever the fields.
template <typename Fields>
struct PointSystem {
  static constexpr int dim = Fields::dim, n_c = Fields::n;

  double S[n_c][dim];
  /// dS_cJ/d(gradient of component d)_L, stored [c][J][L][d]: the inner loop runs over d.
  double M[n_c][dim][dim][n_c];
  /// dS_cJ/dtheta.
  double m[n_c][dim];

  void clear() { *this = PointSystem(); }

  /// Multiply by the integration weight @p w what will be used.
  void scale(const double w, const bool with_tangent)
  {
    for (auto& row : S)
      for (double& entry : row)
        entry *= w;
    if (with_tangent) {
      for (auto& cJ : M)
        for (auto& J : cJ)
          for (auto& L : J)
            for (double& entry : L)
              entry *= w;
      for (auto& row : m)
        for (double& entry : row)
          entry *= w;
    }
  }
};

/// What a cell's nodal values give at one point.
struct PointInput {
  PointState<> state;
  Tensor3<1> grad_theta;
};

template <typename Fields>
void add_fluxes(const FirstDerivatives<>& d, PointSystem<Fields>& system)
{
  constexpr int dim = Fields::dim;
  for (int J = 0; J < dim; ++J) {
    for (int i = 0; i < dim; ++i)
      system.S[i][J] += d.P[axis<dim>(i)][axis<dim>(J)];
    if constexpr (Fields::has_potential)
      system.S[Fields::potential][J] += d.D[axis<dim>(J)];
  }
}

template <typename Fields>
void add_moduli(const SecondDerivatives<>& d, PointSystem<Fields>& system)
{
  constexpr int dim = Fields::dim, phi = Fields::potential;
  for (int J = 0; J < dim; ++J)
    for (int L = 0; L < dim; ++L) {
      const int xJ = axis<dim>(J), xL = axis<dim>(L);
      for (int i = 0; i < dim; ++i) {
        const int xi = axis<dim>(i);
        for (int k = 0; k < dim; ++k)
          system.M[i][J][L][k] += d.dP_dF[xi][xJ][axis<dim>(k)][xL];
        if constexpr (Fields::has_potential) { // E = -grad phi and dD/dF = -(dP/dE)^T
          system.M[i][J][L][phi] -= d.dP_dE[xi][xJ][xL];
          system.M[phi][J][L][i] -= d.dP_dE[xi][xL][xJ];
        }
      }
      if constexpr (Fields::has_potential)
        system.M[phi][J][L][phi] -= d.dD_dE[xJ][xL];
    }
  for (int J = 0; J < dim; ++J) {
    for (int i = 0; i < dim; ++i)
      system.m[i][J] += d.dP_dtheta[axis<dim>(i)][axis<dim>(J)];
    if constexpr (Fields::has_potential)
      system.m[phi][J] += d.dD_dtheta[axis<dim>(J)];
  }
}

template <typename Fields>
void add_heat_flux(const HeatFlux& heat, PointSystem<Fields>& system)
{
  constexpr int dim = Fields::dim, theta = Fields::temperature;
  for (int J = 0; J < dim; ++J) {
    const int xJ = axis<dim>(J);
    system.S[theta][J] -= heat.Q[xJ];
    for (int L = 0; L < dim; ++L) {
      const int xL = axis<dim>(L);
      system.M[theta][J][L][theta] -= heat.dQ_dgrad[xJ][xL];
      if constexpr (Fields::has_deformation)
        for (int k = 0; k < dim; ++k)
          system.M[theta][J][L][k] -= heat.dQ_dF[xJ][axis<dim>(k)][xL];
    }
  }
}

} // namespace thelma
