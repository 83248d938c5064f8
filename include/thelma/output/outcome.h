#pragma once

#include <thelma/output/curve.h>
#include <thelma/output/ending.h>
#include <thelma/solvers/newton.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace thelma
{

/// Two fields e between which the stable branch ends; the same one where a path found its limit
/// point.
struct Bracket {
  double e_below, e_above;
  double e_estimated; ///< vertex of the parabola through the last three states

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& e_below& e_above& e_estimated;
  }
};

/// How a run ended and what it cost.
struct Outcome {
  EndReason ended = EndReason::target;
  ExitCode code = ExitCode::success; ///< that of the reason, if nothing else was expected
  std::string reason;                ///< a sentence
  std::optional<Bracket> pull_in;

  unsigned int steps = 0, failed_steps = 0, ranks = 1;
  NewtonEffort effort;
  double seconds = 0.;
  std::map<std::string, double> seconds_per_phase;
  std::map<std::string, unsigned long long> unknowns;
  unsigned long long cells = 0;
  std::map<std::string, double> imbalance; ///< largest share of a rank over the mean
  double ghost_share = 0.; ///< most unknowns a rank needs of others, over the mean of its own
  std::vector<std::string> modelled;
  std::vector<std::pair<std::string, double>> final_values; ///< newest row of the curve

  /// From now on it has ended so; @p details go on after the sentence of the @p why.
  void end(EndReason why, const std::string& details);

  std::string name() const { return ending_of(ended).name; }

  /// Whether nothing has ended the run before its target.
  bool has_reached_target() const
  {
    return code == ExitCode::success && ended == EndReason::target;
  }

  /// Whether the same run would end alike: not after it was stopped, nor after an error that the
  /// input or the program can lose while the parameters stay the same.
  bool is_lasting() const
  {
    return code != ExitCode::bad_input && code != ExitCode::internal_error &&
           code != ExitCode::stopped;
  }

  /// What is known of it on the way.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    bool has_pull_in = pull_in.has_value();
    archive& failed_steps& effort& has_pull_in;
    if (has_pull_in && !pull_in)
      pull_in.emplace();
    if (has_pull_in)
      archive&* pull_in;
  }

  /// One line for the console.
  std::string summary() const;
};

/// Values a .prm expects at the end, each a muParser expression of theta (K).
class Expectations
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Evaluate the expressions at the temperature @p theta in K. Throws InputError for a column
  /// that is not among @p columns or an expression that cannot be read.
  void setup(const std::vector<std::string>& columns, double theta);

  /// Empty if all hold, otherwise a sentence about the first that does not.
  std::string check(const Curve& curve) const;

private:
  std::map<std::string, std::string> values;
  std::map<std::string, double> expected;
  double tolerance = 1e-3;
};

} // namespace thelma
