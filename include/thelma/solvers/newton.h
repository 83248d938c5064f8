#pragma once

#include <thelma/solvers/linear_solver.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// Size of a residual, each field in units of its own (theory.md, "Residual norms").
struct ResidualReport {
  double norm;      ///< largest of the fields' scaled norms
  double min_det_F; ///< over every quadrature point of every rank
  bool admissible() const { return min_det_F > 0. && norm < 1e300; }

  /// The norm is the largest of its parts, and infinite if one of them is not a number, as where a
  /// law has no stress.
  void include(const double part)
  {
    if (!(part <= norm))
      norm = std::isnan(part) ? std::numeric_limits<double>::infinity() : part;
  }

  /// Why it is not admissible.
  std::string defect() const { return min_det_F > 0. ? "no finite stress" : "det F <= 0"; }
};

/// What Newton's method needs to know of a nonlinear system.
class NonlinearSystem
{
public:
  virtual ~NonlinearSystem() = default;

  /// A solution is sought from the current iterate on.
  virtual void begin() {}

  /// A solution has been found: let what begin() has taken from the iterate then follow it now.
  /// Whether anything has changed.
  virtual bool follow() { return false; }

  /// Residual at the current iterate.
  virtual ResidualReport residual() = 0;

  /// Which law does not reach the current iterate, a sentence; empty if all do.
  virtual std::string law_defect() const { return {}; }

  /// Solve for the correction of the current iterate, which becomes the base: with its own tangent
  /// or, to @p reuse it, with the last one factorised.
  virtual LinearReport linear_solve(bool reuse) = 0;

  /// Iterate = base + @p step * correction.
  virtual void move_to(double step) = 0;

  /// How much of the residual's norm is made by the last digit of the iterate.
  virtual double rounding() = 0;
};

/// What nonlinear solves cost.
struct NewtonEffort {
  unsigned int iterations = 0;        ///< corrections
  unsigned int factorisations = 0;    ///< tangents among them
  unsigned int linear_iterations = 0; ///< of a Krylov method, in all corrections

  void add(const NewtonEffort& other)
  {
    iterations += other.iterations;
    factorisations += other.factorisations;
    linear_iterations += other.linear_iterations;
  }

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& iterations& factorisations& linear_iterations;
  }
};

/// Why a state is not accepted.
enum class Refusal {
  none,
  unstable, ///< it has unstable directions
  no_law,   ///< a law does not reach it
  jump      ///< it is not the continuation of the path
};

/// Why there is no next state.
struct Failure {
  std::string reason;
  Refusal refusal = Refusal::none;

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& reason& refusal;
  }
};

/// Outcome of one nonlinear solve; a failure is a value.
struct [[nodiscard]] NewtonReport : NewtonEffort, Failure {
  bool converged = false;
  std::vector<double> residuals;
  double rounding = 0.; ///< of the last residual, where it was asked for
  double min_det_F = 0.;
  long long negative_pivots = 0;      ///< of the last tangent
  long long most_negative_pivots = 0; ///< of all tangents
  bool reused = false;                ///< whether the last tangent has served more than once

  /// On from the solution found to that of a changed system.
  void go_on(const NewtonReport& next)
  {
    add(next);
    converged = next.converged;
    static_cast<Failure&>(*this) = next;
    residuals.back() = next.residuals.back();
    min_det_F = next.min_det_F;
    most_negative_pivots = std::max(most_negative_pivots, next.most_negative_pivots);
    negative_pivots = next.factorisations > 0 ? next.negative_pivots : negative_pivots;
    reused = next.reused;
  }

  /// The state that was found is not accepted, for this reason.
  void refuse(const Refusal why, std::string sentence)
  {
    converged = false;
    refusal = why;
    reason = std::move(sentence);
  }
};

/// Newton's method. The line search only keeps det F > 0: near incompressibility the residual of
/// a good step may well grow before it falls.
///
/// A tangent serves again as long as the residual falls so fast that the iterations it still takes
/// cost less than a new one. While the iteration contracts, the tangent of the solution has in
/// every direction that takes part the signs of the old one, so the count of negative pivots still
/// holds.
///
/// A residual that a fresh tangent no longer halves, and that is no larger than what rounding makes
/// of it, has converged as far as it can, be it above the tolerance.
class Newton
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// @p reuse: the last tangent factorised is that of a state nearby and serves as long as it will.
  /// Otherwise every state found comes with a tangent, and the count of its negative pivots.
  NewtonReport solve(NonlinearSystem& system, bool reuse = false) const;

  /// Correct a state on, with the last tangent, until its residual is below @p residual or made of
  /// rounding: to where differences between states nearby are known.
  NewtonEffort refine(NonlinearSystem& system, double residual) const;

  /// Iterations without the one that began next to the tolerance, for rounding decides whether it
  /// is made: what the next step's size is chosen by, the same on any number of ranks.
  unsigned int telling_iterations(const NewtonReport& report) const;

  /// The scaled residual of a state that has converged.
  double converged_residual() const { return tolerance; }

private:
  NewtonReport iterate(NonlinearSystem& system, bool reuse) const;
  bool worth_reusing(const NewtonReport& report, const LinearReport& linear) const;
  bool is_rounding(NonlinearSystem& system, NewtonReport& report) const;

  double tolerance = 1e-10;
  bool reuses = true;
  unsigned int max_iterations = 14;
};

} // namespace thelma
