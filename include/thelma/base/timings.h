#pragma once

#include <chrono>
#include <map>
#include <string>

namespace thelma
{

/// Seconds of wall time spent in each named phase on this rank.
class Timings
{
public:
  /// Adds the time until its destruction to one phase.
  class Scope
  {
  public:
    explicit Scope(double& seconds) : seconds(seconds), start(Clock::now()) {}
    ~Scope() { seconds += std::chrono::duration<double>(Clock::now() - start).count(); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& seconds;
    Clock::time_point start;
  };

  Scope measure(const std::string& phase) { return Scope(phases[phase]); }
  const std::map<std::string, double>& seconds() const { return phases; }

private:
  std::map<std::string, double> phases;
};

} // namespace thelma
