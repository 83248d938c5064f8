#pragma once

#include <thelma/base/lanes.h>
#include <thelma/materials/point.h>

#include <vector>

namespace thelma
{

/// A function through values at temperatures: cubic pieces with continuous slopes that never leave
/// the range of the two values around (theory.md, eq. 18). No number outside the temperatures.
class TemperatureTable
{
public:
  TemperatureTable() = default;

  /// Throws InputError, with a sentence without place, unless there are at least two temperatures
  /// (K) and each is higher than the one before.
  TemperatureTable(const std::vector<double>& temperatures, const std::vector<double>& values);

  bool empty() const { return pieces.empty(); }
  void scale(double factor);
  double first() const { return pieces.front().start; }
  double last() const { return end; }

  bool has(const double theta) const { return &piece(theta) != &outside; }

  template <typename Number>
  Number value(const Number& theta) const
  {
    const Cubic<Given<Number>> p = at(theta);
    const Number t = theta - p.start;
    return p.a[0] + t * (p.a[1] + t * (p.a[2] + t * p.a[3]));
  }

  template <typename Number>
  Number slope(const Number& theta) const
  {
    const Cubic<Given<Number>> p = at(theta);
    const Number t = theta - p.start;
    return p.a[1] + t * (2. * p.a[2] + 3. * t * p.a[3]);
  }

  template <typename Number>
  Number curvature(const Number& theta) const
  {
    const Cubic<Given<Number>> p = at(theta);
    const Number t = theta - p.start;
    return 2. * p.a[2] + 6. * t * p.a[3];
  }

private:
  /// a_0 + a_1 t + a_2 t^2 + a_3 t^3 with t = theta - start.
  template <typename Value = double>
  struct Cubic {
    Value start, a[4];
  };

  static const Cubic<> outside; ///< no number

  /// The piece at @p theta, at each lane its own.
  template <typename Number>
  Cubic<Given<Number>> at(const Number& theta) const
  {
    if constexpr (std::is_same<Number, Lanes>::value) {
      Cubic<Lanes> all{};
      for (unsigned int lane = 0; lane < Lanes::n; ++lane) {
        const Cubic<>& one = piece(theta[lane]);
        all.start.set(lane, one.start);
        for (unsigned int k = 0; k < 4; ++k)
          all.a[k].set(lane, one.a[k]);
      }
      return all;
    } else
      return piece(theta);
  }

  template <typename Number>
  const Cubic<>& piece(const Number& theta) const
  {
    constexpr double rounding = 1e-6; // K, of a wall at the end of the table
    if (!(theta >= first() - rounding && theta <= end + rounding))
      return outside;
    std::size_t k = pieces.size() - 1;
    while (k > 0 && theta < pieces[k].start)
      --k;
    return pieces[k];
  }

  std::vector<Cubic<>> pieces;
  double end = 0.; ///< K
};

} // namespace thelma
