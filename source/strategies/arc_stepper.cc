#include <thelma/strategies/arc_stepper.h>

#include <algorithm>

namespace thelma
{

void ArcStepper::accept(const unsigned int newton_iterations, const double prediction_error,
                        const double longest)
{
  constexpr unsigned int easy = 4, hard = 8;
  constexpr double small = 0.1, large = 0.4;
  if (newton_iterations >= hard || prediction_error > large)
    size /= 2.;
  else if (newton_iterations <= easy && prediction_error < small)
    size *= 1.5;
  size = std::min(size, longest);
}

} // namespace thelma
