#include <thelma/base/error.h>
#include <thelma/loads/nodal_forces.h>

#include <cmath>

namespace thelma
{

template <int dim>
std::function<Density<dim>(const Cell<dim>&)>
densities_at(const double time, const Distributions<dim>& densities, const Mesh<dim>& mesh,
             const double factor)
{
  return [&mesh, &densities, time, factor](const Cell<dim>& cell) -> Density<dim> {
    const auto found = densities.find(mesh.region_of(cell.iterator));
    if (found == densities.end())
      return {};
    return [&density = found->second, time, factor](const unsigned int c,
                                                    const dealii::Point<dim>& X) {
      return factor * density(c, X, time);
    };
  };
}

template <int dim>
void NodalForces<dim>::setup(const SceneEntry& entry, const DofLayout<dim>& layout,
                             const bool changes, Integrate how)
{
  place = entry.place();
  in_time = changes;
  integrate = std::move(how);
  if (in_time && !layout.is_transient())
    throw InputError(place + ": t is the time, but nothing evolves in this scene; write the "
                             "expression without it, or set Time/Analysis = transient");
  forces = layout.new_vector();
  integrate_at(0.);
}

template <int dim>
void NodalForces<dim>::add(const double factor, const double time, BlockVector& nodal) const
{
  if (in_time && time != last)
    integrate_at(time);
  nodal.add(factor, forces);
}

template <int dim>
void NodalForces<dim>::integrate_at(const double time) const
{
  last = time;
  forces = 0.;
  integrate(time, forces);
  forces.compress(dealii::VectorOperation::add);
  if (!std::isfinite(forces.l1_norm()))
    throw InputError(place + ": it is not finite everywhere" +
                     (in_time ? " at t = " + as_text(time) + " s" : std::string()) +
                     "; write an expression that is");
}

template std::function<Density<2>(const Cell<2>&)> densities_at(double, const Distributions<2>&,
                                                                const Mesh<2>&, double);
template std::function<Density<3>(const Cell<3>&)> densities_at(double, const Distributions<3>&,
                                                                const Mesh<3>&, double);
template class NodalForces<2>;
template class NodalForces<3>;

} // namespace thelma
