#pragma once

#include <algorithm>
#include <chrono>

/// Seconds of the shortest of some repetitions: what is not the code's only adds.
template <typename Action>
double shortest_seconds(const Action& action)
{
  constexpr int repetitions = 20;
  double shortest = 1e300;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    action();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    shortest = std::min(shortest, time.count());
  }
  return shortest;
}
