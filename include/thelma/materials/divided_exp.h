#pragma once

#include <thelma/base/lanes.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace thelma
{

/// Divided difference of exp at 2x and 2y, (a^2 - b^2)/(2 h), to rounding also where they meet:
/// given h = x - y, a = e^x and b = e^y. It is a b sinh(h)/h, a series below h = 1. Without
/// branches.
template <typename Number>
Number exp_difference(const Number& h, const Number& a, const Number& b)
{
  const Number s = h * h;
  Number sum = 1.;
  for (unsigned int k = 9; k > 0; --k)
    sum = 1. + 1. / (2. * k * (2. * k + 1.)) * s * sum;
  return below(s, 1., Number(a * b * sum), Number((a * a - b * b) / (2. * h)));
}

/// Second divided difference of exp at three places, to rounding: near each other by the series of
/// the complete homogeneous polynomials of their distances from the middle.
inline double exp_second_difference(const double x_0, const double x_1, const double x_2)
{
  std::array<double, 3> x{{x_0, x_1, x_2}};
  std::sort(x.begin(), x.end());
  const auto difference = [&](const unsigned int i, const unsigned int k) {
    return exp_difference((x[k] - x[i]) / 2., std::exp(x[k] / 2.), std::exp(x[i] / 2.));
  };
  if (x[2] - x[0] > 1.)
    return (difference(1, 2) - difference(0, 1)) / (x[2] - x[0]);
  const double middle = (x[0] + x[1] + x[2]) / 3.;
  double of_one = 1., of_two = 1., of_three = 1., factorial = 2., sum = 0.5;
  for (unsigned int k = 1; k <= 17; ++k) {
    of_one *= x[0] - middle;
    of_two = of_one + (x[1] - middle) * of_two;
    of_three = of_two + (x[2] - middle) * of_three;
    factorial *= k + 2;
    sum += of_three / factorial;
  }
  return std::exp(middle) * sum;
}

} // namespace thelma
