#pragma once

#include <thelma/base/lanes.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace thelma
{

/// A value with its first and second derivatives by @p n variables, exact by the chain rule
/// (forward mode). Second derivatives are a lower triangle: by the variables a >= b at second(a,
/// b).
template <typename Number, std::size_t n>
struct Jet {
  static constexpr std::size_t second(const std::size_t a, const std::size_t b)
  {
    return a >= b ? a * (a + 1) / 2 + b : second(b, a);
  }

  /// The variable @p a itself.
  static Jet variable(const Number& value, const std::size_t a)
  {
    Jet x = constant(value);
    x.first[a] = 1.;
    return x;
  }

  static Jet constant(const Number& value)
  {
    Jet x;
    x.value = value;
    x.first.fill(Number(0.));
    x.seconds.fill(Number(0.));
    return x;
  }

  /// A function of it, of which @p f, @p slope and @p curvature are given.
  Jet through(const Number& f, const Number& slope, const Number& curvature) const
  {
    Jet y;
    y.value = f;
    for (std::size_t a = 0; a < n; ++a) {
      y.first[a] = slope * first[a];
      for (std::size_t b = 0; b <= a; ++b)
        y.seconds[second(a, b)] = slope * seconds[second(a, b)] + curvature * first[a] * first[b];
    }
    return y;
  }

  friend Jet operator+(const Jet& x, const Jet& y)
  {
    Jet sum = x;
    sum.value += y.value;
    for (std::size_t a = 0; a < n; ++a)
      sum.first[a] += y.first[a];
    for (std::size_t k = 0; k < sum.seconds.size(); ++k)
      sum.seconds[k] += y.seconds[k];
    return sum;
  }

  friend Jet operator*(const Jet& x, const Jet& y)
  {
    Jet product;
    product.value = x.value * y.value;
    for (std::size_t a = 0; a < n; ++a) {
      product.first[a] = x.value * y.first[a] + y.value * x.first[a];
      for (std::size_t b = 0; b <= a; ++b) {
        const std::size_t k = second(a, b);
        product.seconds[k] = x.value * y.seconds[k] + y.value * x.seconds[k] +
                             x.first[a] * y.first[b] + x.first[b] * y.first[a];
      }
    }
    return product;
  }

  Number value;
  std::array<Number, n> first;
  std::array<Number, n*(n + 1) / 2> seconds;
};

template <typename Number, std::size_t n>
Jet<Number, n> exp(const Jet<Number, n>& x)
{
  using std::exp;
  const Number f = exp(x.value);
  return x.through(f, f, f);
}

/// No number where @p x is not positive.
template <typename Number, std::size_t n>
Jet<Number, n> log(const Jet<Number, n>& x)
{
  using std::log;
  const Number slope = 1. / positive(x.value);
  return x.through(Number(log(x.value)), slope, Number(-slope * slope));
}

/// x^p; a whole number @p p allows any x.
template <typename Number>
Number power(const Number& x, const double p)
{
  using std::exp;
  using std::log;
  constexpr double largest = 64.; // of those made by products
  if (p != std::round(p) || std::abs(p) > largest)
    return exp(Number(p * log(positive(x))));
  Number result = 1.;
  for (double k = 0.; k < std::abs(p); ++k)
    result *= x;
  return p < 0. ? Number(1. / result) : result;
}

template <typename Number, std::size_t n>
Jet<Number, n> power(const Jet<Number, n>& x, const double p)
{
  const Number slope = p == 0. ? Number(0.) : Number(p * power(x.value, p - 1.));
  const Number curvature =
      p == 0. || p == 1. ? Number(0.) : Number(p * (p - 1.) * power(x.value, p - 2.));
  return x.through(power(x.value, p), slope, curvature);
}

} // namespace thelma
