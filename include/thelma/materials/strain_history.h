#pragma once

#include <thelma/materials/point.h>

#include <cmath>

namespace thelma
{

/// A symmetric tensor as six numbers in the order 00 11 22 01 02 12.
inline constexpr unsigned int n_symmetric = 6;

inline constexpr unsigned int symmetric_index(const unsigned int i, const unsigned int j)
{
  return i == j ? i : i + j + 2;
}

inline Tensor3<2> symmetric(const double* numbers)
{
  Tensor3<2> A;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      A[i][j] = numbers[symmetric_index(i, j)];
  return A;
}

inline void put_symmetric(const Tensor3<2>& A, double* numbers)
{
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      numbers[symmetric_index(i, j)] = A[i][j];
}

/// C_iso = j F^T F with j = J^{-2/3}.
template <typename Number>
struct IsochoricStrain {
  IsochoricStrain(const Tensor3<2, Number>& F, const Number& J)
  {
    using std::exp;
    using std::log;
    j = exp(-2. / 3. * log(J));
    C = j * (dealii::transpose(F) * F);
  }

  Number j;
  Tensor3<2, Number> C;
};

/// What all branches of a point are told of its past: the strain C_iso and the temperature in K of
/// the last accepted states, which it remembers for them.
struct StrainHistory {
  static constexpr unsigned int n = n_symmetric + 1; ///< numbers remembered: C_iso, theta

  /// Of the last accepted state, and the one before it if there is one.
  StrainHistory(const StepTimes& times, const double* old, const double* older)
      : dt(times.dt), dt_before(times.dt_before), order(times.order), C_iso_old(symmetric(old)),
        theta_old(old[n_symmetric])
  {
    constexpr double tiny = 1e-3; // a jump is stepped over at once
    if (older && times.dt_before > tiny * times.dt) {
      C_iso_older = symmetric(older);
      theta_older = older[n_symmetric];
    } else
      dt_before = 0.;
  }

  /// The state at the end of the step.
  void arrive(const double* now)
  {
    C_iso = symmetric(now);
    theta = now[n_symmetric];
  }

  /// Second derivative of C_iso times dt^2, by the three states; without an older one, as though
  /// C_iso had rested before.
  Tensor3<2> bend() const
  {
    if (!(dt_before > 0.))
      return C_iso - C_iso_old;
    return 2. * dt / (dt + dt_before) *
           (C_iso - C_iso_old - dt / dt_before * (C_iso_old - C_iso_older));
  }

  double dt, dt_before; ///< s; 0: there is no older state
  unsigned int order;
  Tensor3<2> C_iso, C_iso_old, C_iso_older;
  double theta = 0., theta_old, theta_older = 0.;
};

} // namespace thelma
