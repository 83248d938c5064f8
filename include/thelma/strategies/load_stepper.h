#pragma once

#include <deal.II/base/parameter_handler.h>

namespace thelma
{

/// Chooses load factors between 0 and 1: grows after easy steps, shrinks after hard ones, halves
/// after failures, and brackets a load beyond which there is no state.
class LoadStepper
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Begin at load 0; give up when a failed load is within @p resolution of an accepted one.
  void start(double resolution) { start(resolution, initial); }
  void start(double resolution, double first_step);

  /// Next load factor to try.
  double next();

  /// @p estimated_limit: where the path through the last states would end by itself; a failure
  /// well before it was one of the method, not of the body, and is forgotten.
  void accept(unsigned int newton_iterations, double estimated_limit);

  /// The trial load failed. Where a state was found, but not that of the path (@p jumped), the path
  /// may bend within the resolution: there the loads may come nearer than that.
  void cut_back(bool jumped = false);

  bool finished() const { return load >= 1.; }
  bool exhausted() const { return failed_from == load && upper - load <= nearest; }

  /// Whether the trial step is near the smallest there is.
  bool finest() const { return trial - load <= 4. * resolution; }

  double accepted() const { return load; }
  double step() const { return size; }
  double largest_step() const { return largest; }

  /// Smallest load factor known to fail; above 1 if there is none.
  double failed() const { return upper; }

  /// How far it has come.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& resolution& nearest& load& size& trial& upper& failed_from& expected_limit;
  }

private:
  double initial = 0.05, largest = 0.1;
  unsigned int easy = 4, hard = 8;

  double resolution = 0., nearest = 0., load = 0., size = 0., trial = 0.;
  double upper = 2., failed_from = -1., expected_limit = 0.;
};

} // namespace thelma
