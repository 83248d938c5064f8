#include <thelma/base/parameters.h>
#include <thelma/strategies/load_stepper.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace thelma
{
namespace
{
constexpr double no_failure = 2.; // above every load factor
constexpr double fast = 3.;       // no step is as many times as long as the one before
} // namespace

void LoadStepper::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Stepping"});
  prm.add_parameter("Initial step", initial, "First load step as a fraction of the target.",
                    Double(1e-12, 1.));
  prm.add_parameter("Largest step", largest, "Largest load step as a fraction of the target.",
                    Double(1e-12, 1.));
  prm.add_parameter("Easy iterations", easy, "Steps of at most so many Newton iterations grow.",
                    Integer(1));
  prm.add_parameter("Hard iterations", hard, "Steps of at least so many Newton iterations shrink.",
                    Integer(1));
}

void LoadStepper::start(const double bracket, const double first_step)
{
  resolution = nearest = bracket;
  load = trial = 0.;
  size = first_step;
  upper = no_failure;
  failed_from = -1.;
  expected_limit = std::numeric_limits<double>::infinity();
}

double LoadStepper::next()
{
  if (upper >= no_failure) {
    // Towards a limit the path announces, and past it only from next to it: failures are expensive.
    const double ahead = expected_limit - load;
    const double step = ahead > 0. ? std::min(size, std::max(0.7 * ahead, resolution)) : size;
    const double left = 1. - load, n_steps = std::ceil(left / step * (1. - 1e-12));
    trial = n_steps <= 1. ? 1. : load + (n_steps <= 3. ? left / n_steps : step);
  } else if (upper - load > nearest)
    trial = std::min(load + size, (load + upper) / 2.);
  else // so close a failure must show itself again, from here
    trial = upper;
  return trial;
}

void LoadStepper::accept(const unsigned int newton_iterations, const double estimated_limit)
{
  const double taken = trial - load;
  load = trial;
  if (load >= upper || estimated_limit > upper + (upper - load))
    upper = no_failure;
  expected_limit = estimated_limit;
  if (newton_iterations <= easy)
    size = std::min((2 * newton_iterations <= easy ? fast : 1.5) * size, largest);
  else if (newton_iterations >= hard)
    size /= 2.;
  size = std::min(size, fast * taken); // farther ahead than that nothing is foretold
}

void LoadStepper::cut_back(const bool jumped)
{
  constexpr double finer = 1e-3;
  nearest = jumped ? finer * resolution : resolution;
  upper = std::min(upper, trial);
  failed_from = load;
  size = std::min(size, trial - load) / 2.;
}

} // namespace thelma
