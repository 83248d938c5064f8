#pragma once

#include <thelma/base/lanes.h>

#include <deal.II/base/tensor.h>

#include <cmath>
#include <limits>
#include <type_traits>

/// The point physics is always three-dimensional and independent of any mesh. Components follow
/// the paper: P_iJ = P[i][J], dP_iJ/dF_kL = dP_dF[i][J][k][L]. Units: mm, N, MPa, kV, K.
namespace thelma
{

template <int rank, typename Number = double>
using Tensor3 = dealii::Tensor<rank, 3, Number>;

/// A value that is given whatever is differentiated: one, or one for each lane.
template <typename Number>
using Given = std::conditional_t<std::is_same<Number, Lanes>::value, Lanes, double>;

/// A step from the last accepted state, after one of the length dt_before; of the order of its
/// differences.
struct StepTimes {
  double dt = 0., dt_before = 0.; ///< s; 0: no time, no step before
  unsigned int order = 2;
};

/// What has become of a point's past for the step to the state: numbers of the laws that remember.
/// Null: all has relaxed, or nothing remembers.
template <typename Value = double>
struct PointHistory {
  const Value* step = nullptr;

  bool is_relaxed() const { return step == nullptr; }
};

/// What a material law sees: deformation gradient F, nominal electric field E in kV/mm, absolute
/// temperature theta in K and what it remembers.
template <typename Number = double>
struct PointState {
  Tensor3<2, Number> F;
  Tensor3<1, Number> E;
  Number theta;
  PointHistory<Given<Number>> history = {};
};

/// P in MPa, D in N/(kV mm), eta in MPa/K.
template <typename Number = double>
struct FirstDerivatives {
  Tensor3<2, Number> P;
  Tensor3<1, Number> D;
  Number eta;
};

/// Derivatives of P, D and eta. The others follow from the common potential:
/// dD/dF = -(dP/dE)^T, deta/dF = -dP/dtheta, deta/dE = dD/dtheta.
template <typename Number = double>
struct SecondDerivatives {
  Tensor3<4, Number> dP_dF;
  Tensor3<3, Number> dP_dE;
  Tensor3<2, Number> dP_dtheta;
  Tensor3<2, Number> dD_dE;
  Tensor3<1, Number> dD_dtheta;
  Number deta_dtheta;
};

/// Volumetric energy psi_v(J, theta), kept apart from the rest so that an element formulation can
/// integrate it by its own rule or give it its own dilatation.
template <typename Number = double>
struct Volumetric {
  Number psi;         ///< MPa
  Number p;           ///< dpsi_v/dJ, MPa
  Number dp_dJ;       ///< MPa
  Number dp_dtheta;   ///< MPa/K
  Number eta;         ///< -dpsi_v/dtheta, MPa/K
  Number deta_dtheta; ///< MPa/K^2
};

/// W and its derivatives with respect to F_EM and theta (at fixed F_EM). An elastic law fills one
/// of these; Material adds the entropic factor theta/theta_0 and the thermal split.
template <typename Number = double>
struct ElasticDerivatives {
  Number W, W_theta, W_thetatheta;
  Tensor3<2, Number> W_F, W_Ftheta;
};

/// Rate of entropy h = deta/dF : F_dot + deta/dE . E_dot that deformation and field cause, so that
/// the structural heat is H = -theta h (theory.md, eq. 35), and its derivatives.
struct EntropyRate {
  double h = 0.;            ///< MPa/(K s)
  Tensor3<2> d_dF, d_dFdot; ///< each at a fixed value of the other
  Tensor3<1> d_dE, d_dEdot;
  double d_dtheta = 0.;
};

/// F_dot in 1/s and E_dot in kV/(mm s).
struct PointRates {
  Tensor3<2> F;
  Tensor3<1> E;
};

/// Fourier's law: nominal heat flux Q in N/(mm s) and its derivatives.
template <typename Number = double>
struct HeatFlux {
  Tensor3<1, Number> Q;
  Tensor3<2, Number> dQ_dgrad;
  Tensor3<3, Number> dQ_dF; ///< dQ_J/dF_kL = [J][k][L]
};

/// J = det F and G = F^{-T}, from which every derivative of the laws is built.
template <typename Number = double>
struct Kinematics {
  Kinematics() = default;
  explicit Kinematics(const Tensor3<2, Number>& F)
  {
    Tensor3<2, Number> cofactor;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j) {
        const unsigned int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        cofactor[i][j] = F[i1][j1] * F[i2][j2] - F[i1][j2] * F[i2][j1];
      }
    J = F[0][0] * cofactor[0][0] + F[0][1] * cofactor[0][1] + F[0][2] * cofactor[0][2];
    G = cofactor / J;
  }

  Number J;
  Tensor3<2, Number> G;
};

/// Sum of products of all components.
template <int rank, typename Number>
Number contract(const Tensor3<rank, Number>& a, const Tensor3<rank, Number>& b)
{
  return dealii::scalar_product(a, b);
}

template <typename Number>
Number contract(const Tensor3<1, Number>& a, const Tensor3<1, Number>& b)
{
  return a * b;
}

/// A : B over the last two indices of @p A.
template <typename Number>
Tensor3<2, Number> apply(const Tensor3<4, Number>& A, const Tensor3<2, Number>& B)
{
  Tensor3<2, Number> result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int J = 0; J < 3; ++J)
      result[i][J] = dealii::scalar_product(A[i][J], B);
  return result;
}

} // namespace thelma
