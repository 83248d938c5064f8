#include <thelma/strategies/arc_stepper.h>

#include <algorithm>

namespace thelma
{

void ArcStepper::accept(const unsigned int newton_iterations, const double surprise,
                        const double longest)
{
  constexpr unsigned int easy = 4, hard = 8;
  constexpr double small = 0.1, large = 0.4;
  if (newton_iterations >= hard || surprise > large)
    size /= 2.;
  else if (newton_iterations <= easy && surprise < small)
    size *= 1.5;
  size = std::min(size, longest);
}

} // namespace thelma
