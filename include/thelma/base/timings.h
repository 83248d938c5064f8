#pragma once

#include <chrono>
#include <map>
#include <string>

namespace thelma
{

/// Wall time since its construction.
class Stopwatch
{
public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start).count(); }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start = Clock::now();
};

/// Seconds of wall time spent in each named phase on this rank.
class Timings
{
public:
  /// Adds the time until its destruction to one phase.
  class Scope
  {
  public:
    explicit Scope(double& seconds) : seconds(seconds) {}
    ~Scope() { seconds += watch.seconds(); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    double& seconds;
    Stopwatch watch;
  };

  Scope measure(const std::string& phase) { return Scope(phases[phase]); }
  const std::map<std::string, double>& seconds() const { return phases; }

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    const std::map<std::string, double> here = phases;
    archive& phases;
    if (Archive::is_loading::value)
      for (const auto& [phase, seconds] : here)
        phases[phase] += seconds;
  }

private:
  std::map<std::string, double> phases;
};

} // namespace thelma
