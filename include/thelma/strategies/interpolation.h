#pragma once

#include <vector>

namespace thelma
{

/// Of a polynomial.
enum class Parity { none, even, odd };

/// Weights of values at @p places in the polynomial of @p parity through them, at @p place.
std::vector<double> weights(const std::vector<double>& places, double place, Parity parity);

} // namespace thelma
