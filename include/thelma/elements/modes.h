#pragma once

#include <array>
#include <numeric>

namespace thelma
{

/// Coefficients of a pressure or dilatation, and matrices over them; unused ones stay zero.
using Modes = std::array<double, 4>;
using ModeMatrix = std::array<Modes, 4>;

inline Modes operator+(Modes x, const Modes& y)
{
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] += y[i];
  return x;
}

inline double operator*(const Modes& x, const Modes& y)
{
  return std::inner_product(x.begin(), x.end(), y.begin(), 0.);
}

inline Modes operator*(const ModeMatrix& A, const Modes& x)
{
  return {{A[0] * x, A[1] * x, A[2] * x, A[3] * x}};
}

/// A B of symmetric matrices.
inline ModeMatrix operator*(const ModeMatrix& A, const ModeMatrix& B)
{
  ModeMatrix C;
  for (std::size_t i = 0; i < C.size(); ++i)
    C[i] = B * A[i];
  return C;
}

/// A += w m x m.
inline void add_square(const Modes& m, const double w, ModeMatrix& A)
{
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t j = 0; j < m.size(); ++j)
      A[i][j] += w * m[i] * m[j];
}

} // namespace thelma
