#include <thelma/elements/product.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// Doubles in one register, wherever they lie.
using Wide = double __attribute__((vector_size(64), aligned(8), may_alias));
using Narrow = double __attribute__((vector_size(32), aligned(8), may_alias));

template <typename Register>
__attribute__((always_inline)) inline void store(const Register& sum, double* C, const bool add)
{
  Register& place = *reinterpret_cast<Register*>(C);
  place = add ? place + sum : sum;
}

/// Some rows of C at a time stay in registers; @p wide and then @p narrow ones make one row.
template <int rows, int wide, int narrow>
__attribute__((always_inline)) inline void multiply(const Product& p)
{
  constexpr std::ptrdiff_t length = 8 * wide + 4 * narrow;
  for (std::ptrdiff_t a = 0; a < length; a += rows) {
    Wide w[rows][std::max(wide, 1)] = {};
    Narrow s[rows][std::max(narrow, 1)] = {};
    for (unsigned int k = 0; k < p.n_k; ++k) {
      const double* A = p.A[k] + a;
      const Wide* b = reinterpret_cast<const Wide*>(p.B + std::size_t(k) * length);
      const Narrow* rest = reinterpret_cast<const Narrow*>(b + wide);
#pragma GCC unroll 8
      for (int r = 0; r < rows; ++r) {
        const double x = A[r];
        const Wide all = {x, x, x, x, x, x, x, x};
        for (int v = 0; v < wide; ++v)
          w[r][v] += all * b[v];
        const Narrow half =
            wide ? Narrow(__builtin_shufflevector(all, all, 0, 1, 2, 3)) : Narrow{x, x, x, x};
        for (int v = 0; v < narrow; ++v)
          s[r][v] += half * rest[v];
      }
    }
#pragma GCC unroll 8
    for (int r = 0; r < rows; ++r) {
      double* C = p.C + (a + r) * length;
      for (std::ptrdiff_t v = 0; v < wide; ++v)
        store(w[r][v], C + 8 * v, p.add);
      for (std::ptrdiff_t v = 0; v < narrow; ++v)
        store(s[r][v], C + length - 4 * (narrow - v), p.add);
    }
  }
}

void plain(const Product& p)
{
  for (unsigned int a = 0; a < p.stride; ++a) {
    double* C = p.C + std::size_t(a) * p.stride;
    if (!p.add)
      std::fill_n(C, p.stride, 0.);
    for (unsigned int k = 0; k < p.n_k; ++k)
      for (unsigned int b = 0; b < p.stride; ++b)
        C[b] += p.A[k][a] * p.B[k * p.stride + b];
  }
}

#ifdef __x86_64__
__attribute__((target("avx512f,avx2,fma"))) void with_avx512(const Product& p)
{
  switch (p.stride) {
  case 4:
    return multiply<4, 0, 1>(p);
  case 8:
    return multiply<8, 1, 0>(p);
  case 12:
    return multiply<4, 1, 1>(p);
  case 28:
    return multiply<4, 3, 1>(p);
  default:
    return plain(p);
  }
}

__attribute__((target("avx2,fma"))) void with_avx2(const Product& p)
{
  switch (p.stride) {
  case 4:
    return multiply<4, 0, 1>(p);
  case 8:
    return multiply<4, 0, 2>(p);
  case 12:
    return multiply<4, 0, 3>(p);
  case 28:
    return multiply<2, 0, 7>(p);
  default:
    return plain(p);
  }
}

bool has_avx2()
{
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
#endif

} // namespace

void product(const Product& p)
{
#ifdef __x86_64__
  static const auto best = has_avx2() && __builtin_cpu_supports("avx512f") ? with_avx512
                           : has_avx2()                                    ? with_avx2
                                                                           : plain;
  best(p);
#else
  plain(p);
#endif
}

} // namespace thelma
