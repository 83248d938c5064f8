#include <thelma/base/error.h>
#include <thelma/base/quantity.h>
#include <thelma/loads/warming.h>

namespace thelma
{

void check_wall_temperature(const double start, const double wall, const double time,
                            const double level)
{
  const double there = start + level * (wall - start);
  if (there < 1. || there > 1e4)
    throw InputError("section Time, entry 'Wall amplitude': it takes a wall of " + as_text(wall) +
                     " K to " + as_text(there) + " K at t = " + as_text(time) +
                     " s; temperatures are at least 1 K and at most 10000 K");
}

template <int dim>
void HeatLoad<dim>::require_field(const SceneEntry& entry, const bool is_given) const
{
  if (is_given && !layout->has(Field::temperature))
    throw InputError(entry.place() + ": there is no temperature field that heat could change; "
                                     "choose Model = steady or transient in the section "
                                     "Temperature");
}

template class HeatLoad<2>;
template class HeatLoad<3>;

} // namespace thelma
