#pragma once

#include <thelma/output/outcome.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// Runs of one scene on ever finer meshes, or with ever shorter steps, each half the one before:
/// two or three, coarsest first.
struct Series {
  std::vector<Outcome> runs;
  std::size_t given = 0;     ///< which of them is the one whose error is wanted
  double highest_order = 1.; ///< in which errors fall at best
};

/// How far a number lies from its limit in a series, probably.
struct Convergence {
  double way = 0., doubt = 0.; ///< to the limit, with its sign, and how much of that is uncertain
  bool has_limit = true;       ///< as far as the series tells
  double error() const { return std::abs(way) + doubt; }
};

/// Of @p values, one of each run of a series (theory.md, eqs. 84 and 85); differences up to
/// @p noise are no sign of anything.
Convergence convergence(const std::vector<double>& values, std::size_t given, double highest_order,
                        double noise);

/// What a run has found, with its uncertainty (that of a bracket, or what Newton's method leaves):
/// the field of its pull-in, the values at its target, or both.
struct Result {
  std::string name;
  double value, uncertainty;
};
std::vector<Result> results(const Outcome& outcome, double newton_tolerance);

/// Why the numbers of @p other, the same scene on another mesh or with other steps, say nothing of
/// the error of those of @p given: it ended otherwise, or followed another branch. Empty if they
/// do.
std::string disagreement(const Outcome& given, const Outcome& other);

/// A doubt about two final states that can be compared; empty if there is none.
std::string doubt(const Outcome& given, const Outcome& other);

} // namespace thelma
