#pragma once

#include <thelma/fields/dof_layout.h>
#include <thelma/solvers/newton.h>

#include <string>
#include <utility>

namespace thelma
{

/// What a path passes.
struct PathEvent {
  enum class Kind { none, limit_point, bifurcation };
  Kind kind = Kind::none;
  long long multiplicity = 1; ///< of a bifurcation

  /// As in the curve.
  std::string name() const;
};

/// What a step has led to: a state, which is the iterate, or none.
struct StepReport {
  NewtonReport newton;
  bool is_accurate = true; ///< as far as the strategy can tell
  double load = 0.;        ///< load factor, or time in s
  double next_step = 0.;   ///< of the load factor, the arc length or the time
  double part = 0.;        ///< of the whole way, if that is known
  long long unstable_directions = 0;
  PathEvent event;

  bool found() const { return newton.converged && is_accurate; }
};

/// Who is told of the states that a strategy accepts, while they are the iterate.
class Recorder
{
public:
  virtual ~Recorder() = default;
  virtual void record(const StepReport& step) = 0;

  /// The critical mode of the bifurcation that was recorded last.
  virtual void record_mode(const BlockVector& mode) = 0;
};

/// Why a strategy takes no further step.
enum class StepsEnd {
  none,
  target,
  observable,  ///< has the value at which the path was to end
  limit_point, ///< was the aim
  turns,       ///< the path goes on along its arc alone
  no_load,     ///< the path has led back to it
  most_steps,
  exhausted ///< no step is short enough
};

/// What steps have cost.
struct StepsEffort {
  NewtonEffort newton;
  unsigned int failed_steps = 0;
};

/// A way through the states of a body, step by step (theory.md, "Prediction", "Path following",
/// "Time"). A new one is one file, and a line where the simulation chooses it.
class Strategy
{
public:
  virtual ~Strategy() = default;

  /// Seek the next state from the last accepted one.
  virtual StepReport advance() = 0;

  /// Make the state that was found the last accepted one.
  virtual void accept(const StepReport& step, Recorder& recorder) = 0;

  /// Return to the last accepted state, and be more careful from there.
  virtual void cut_back(const StepReport& step) = 0;

  virtual StepsEnd end() const = 0;

  /// Whether all that matters is data, so that a checkpoint may be written.
  virtual bool can_pause() const = 0;

  /// What has been spent since this was last asked.
  StepsEffort take_effort() { return std::exchange(spent, {}); }

protected:
  StepsEffort spent;
};

} // namespace thelma
