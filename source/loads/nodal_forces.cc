#include <thelma/base/error.h>
#include <thelma/loads/nodal_forces.h>

#include <algorithm>
#include <cmath>

namespace thelma
{

template <int dim>
void require_region(const Mesh<dim>& mesh, const std::string& name, const std::string& place)
{
  const auto& regions = mesh.regions();
  if (std::find(regions.begin(), regions.end(), name) == regions.end())
    throw InputError(place + ": the mesh has no region '" + name + "'" +
                     did_you_mean(name, regions));
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

template void require_region(const Mesh<2>&, const std::string&, const std::string&);
template void require_region(const Mesh<3>&, const std::string&, const std::string&);
template class NodalForces<2>;
template class NodalForces<3>;

} // namespace thelma
