#pragma once

namespace thelma
{

/// Chooses lengths of steps along a path: they grow after easy steps, shrink after hard ones and
/// halve after failures.
class ArcStepper
{
public:
  void start(const double first, const double smallest_step)
  {
    size = first;
    smallest = smallest_step;
  }
  double step() const { return size; }
  bool exhausted() const { return !(size >= smallest); }

  /// A step of this @p length has failed.
  void cut_back(const double length) { size = length / 2.; }

  /// @p prediction_error: distance of the state from its guess over the length of the step.
  void accept(unsigned int newton_iterations, double prediction_error, double longest);

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& size& smallest;
  }

private:
  double size = 0., smallest = 0.;
};

} // namespace thelma
