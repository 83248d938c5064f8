#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace thelma
{

/// What deformation and field contribute to the heat balance of a transient scene: nothing, the
/// structural heat H, or the rate of entropy theta eta_dot (theory.md, eqs. 35, 38).
enum class StructuralHeat { none, power, entropy };

/// Backward differences: the rate of x is weights[0] x + weights[1] x_1 + ... with the accepted
/// states x_1, x_2, newest first, and the weights in 1/s (theory.md, eq. 36).
struct Rates {
  std::array<double, 3> weights{};
  std::size_t n_past = 1;
  unsigned int order = 1; ///< of the scheme; its first step may be of the first
  StructuralHeat heat = StructuralHeat::none;

  /// Rate of a value now and @p past, newest first. Differences keep what is small beside the
  /// values themselves.
  template <typename Past>
  double of(const double now, const Past& past) const
  {
    double rate = 0.;
    for (std::size_t k = 0; k < n_past; ++k)
      rate -= weights[k + 1] * (now - past(k));
    return rate;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& weights& n_past& order& heat;
  }
};

/// The differences of @p order 1 or 2 at the @p time, given the @p times of the accepted states,
/// newest last.
Rates backward_differences(double time, const std::vector<double>& times, unsigned int order);

} // namespace thelma
