#pragma once

#include <deal.II/base/template_constraints.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace thelma
{

/// Several doubles that are computed with at once, in one or two registers: a number type for the
/// point physics at as many points.
struct Lanes {
#ifdef __AVX512F__
  static constexpr unsigned int n = 8;
#else
  static constexpr unsigned int n = 4;
#endif
  using Register = double __attribute__((vector_size(n * sizeof(double))));

  Lanes() = default;
  Lanes(const double x) : v(x - Register{}) {} // NOLINT: numbers become lanes by themselves
  explicit Lanes(const Register& v) : v(v) {}

  double operator[](const unsigned int lane) const
  {
    return v[lane];
  }
  void set(const unsigned int lane, const double x)
  {
    v[lane] = x;
  }

  Lanes& operator+=(const Lanes& x)
  {
    return *this = *this + x;
  }
  Lanes& operator-=(const Lanes& x)
  {
    return *this = *this - x;
  }
  Lanes& operator*=(const Lanes& x)
  {
    return *this = *this * x;
  }
  Lanes& operator/=(const Lanes& x)
  {
    return *this = *this / x;
  }

  friend Lanes operator-(const Lanes& x)
  {
    return Lanes(-x.v);
  }
  friend Lanes operator+(const Lanes& x, const Lanes& y)
  {
    return Lanes(x.v + y.v);
  }
  friend Lanes operator-(const Lanes& x, const Lanes& y)
  {
    return Lanes(x.v - y.v);
  }
  friend Lanes operator*(const Lanes& x, const Lanes& y)
  {
    return Lanes(x.v * y.v);
  }
  friend Lanes operator/(const Lanes& x, const Lanes& y)
  {
    return Lanes(x.v / y.v);
  }

  friend Lanes exp(const Lanes& x)
  {
    return x.each([](const double y) { return std::exp(y); });
  }
  friend Lanes log(const Lanes& x)
  {
    return x.each([](const double y) { return std::log(y); });
  }
  friend Lanes sqrt(const Lanes& x)
  {
    return x.each([](const double y) { return std::sqrt(y); });
  }

  template <typename Function>
  Lanes each(const Function& f) const
  {
    Lanes result;
    for (unsigned int lane = 0; lane < n; ++lane)
      result.v[lane] = f(v[lane]);
    return result;
  }

  Register v;
};

/// The number, or as many as there are lanes, at @p place.
template <typename Number>
Number load(const double* place)
{
  Number x{};
  if constexpr (std::is_same<Number, Lanes>::value)
    for (unsigned int lane = 0; lane < Lanes::n; ++lane)
      x.set(lane, place[lane]);
  else
    x = *place;
  return x;
}

/// @p x where it is positive; elsewhere no number.
template <typename Number>
Number positive(const Number& x)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if constexpr (std::is_same<Number, Lanes>::value)
    return x.each([nan](const double y) { return y > 0. ? y : nan; });
  else
    return x > 0. ? x : Number(nan);
}

/// @p low where @p x is below @p limit, @p high elsewhere.
template <typename Number>
Number below(const Number& x, const double limit, const Number& low, const Number& high)
{
  if constexpr (std::is_same<Number, Lanes>::value)
    return Lanes(x.v < Lanes(limit).v ? low.v : high.v);
  else
    return x < limit ? low : high;
}

} // namespace thelma

namespace dealii
{
template <>
struct EnableIfScalar<thelma::Lanes> {
  using type = thelma::Lanes;
};
} // namespace dealii
