#include <thelma/strategies/load_jump.h>

#include <cmath>

namespace thelma
{

std::vector<double> LoadJump::levels(const double time) const
{
  return levels_between(from, to, (time - start) / (end - start));
}

std::vector<double> levels_between(const std::vector<double>& from, std::vector<double> to,
                                   const double part)
{
  if (part == 1.)
    return to;
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] = from[i] + part * (to[i] - from[i]);
  return to;
}

template <int dim>
std::optional<LoadJump> jump_ahead(const Loads<dim>& loads, const std::vector<double>& accepted,
                                   const double now, const double instant)
{
  constexpr double smooth = 1e-6;
  const std::vector<double> soon = loads.levels_at(now + instant);
  for (std::size_t i = 0; i < loads.size(); ++i)
    if (loads[i].is_present() && loads[i].acts_at_once() &&
        std::abs(soon[i] - accepted[i]) > smooth)
      return LoadJump{now, now + instant, accepted, soon};
  return {};
}

template std::optional<LoadJump> jump_ahead(const Loads<2>&, const std::vector<double>&, double,
                                            double);
template std::optional<LoadJump> jump_ahead(const Loads<3>&, const std::vector<double>&, double,
                                            double);

} // namespace thelma
