#include <thelma/fields/electrodes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/rtree.h>

#include <limits>

namespace thelma
{
namespace
{

/// The nodes of the named surface that belong to @p body, on all ranks.
template <int dim>
std::vector<dealii::Point<dim>> nodes(const Mesh<dim>& mesh, const std::string& surface,
                                      const unsigned int body)
{
  std::vector<double> own, all;
  for (const auto& [cell, vertices] : mesh.surface(surface, ""))
    for (unsigned int v = 0;
         mesh.body_of(cell) == body && v < dealii::GeometryInfo<dim>::vertices_per_cell; ++v)
      if (vertices & (1u << v))
        for (unsigned int d = 0; d < dim; ++d)
          own.push_back(cell->vertex(v)[d]);
  for (const std::vector<double>& part :
       dealii::Utilities::MPI::all_gather(mesh.communicator(), own))
    all.insert(all.end(), part.begin(), part.end());
  std::vector<dealii::Point<dim>> points(all.size() / dim);
  for (std::size_t i = 0; i < all.size(); ++i)
    points[i / dim][i % dim] = all[i];
  return points;
}

} // namespace

template <int dim>
double electrode_distance(const Mesh<dim>& mesh, const std::vector<Electrode>& electrodes)
{
  const auto potential = [](const Electrode& e) { return e.floats ? 1. : e.voltage_multiple; };
  double least = std::numeric_limits<double>::infinity();
  for (unsigned int body = 0; body < mesh.bodies().size(); ++body)
    for (std::size_t a = 0; a < electrodes.size(); ++a) {
      const std::vector<dealii::Point<dim>> from = nodes(mesh, electrodes[a].name, body);
      const auto tree = dealii::pack_rtree(from);
      for (std::size_t b = 0; b < a && !from.empty(); ++b)
        if (std::abs(potential(electrodes[a]) - potential(electrodes[b])) == 1.)
          for (const dealii::Point<dim>& point : nodes(mesh, electrodes[b].name, body)) {
            std::vector<dealii::Point<dim>> nearest;
            tree.query(boost::geometry::index::nearest(point, 1), std::back_inserter(nearest));
            least = std::min(least, point.distance(nearest.front()));
          }
    }
  return std::isfinite(least) ? least : 0.;
}

template double electrode_distance(const Mesh<2>&, const std::vector<Electrode>&);
template double electrode_distance(const Mesh<3>&, const std::vector<Electrode>&);

} // namespace thelma
