#include <thelma/base/error.h>
#include <thelma/loads/free_edges.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/set.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

namespace thelma
{
namespace
{

/// An end of an edge of the surface (in the plane the whole edge): where it is and which
/// displacements are given there.
template <int dim>
struct End {
  std::array<double, dim> X; ///< the same bits on every cell and rank
  std::set<unsigned int> given;

  bool operator<(const End& other) const { return X < other.X; }

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& X& given;
  }
};

template <int dim>
using Edge = std::vector<End<dim>>;

/// The vertices at the ends of the edges of a face with these @p vertices.
template <int dim>
std::vector<std::vector<unsigned int>> corners_of_edges(const std::uint8_t vertices)
{
  using Geometry = dealii::GeometryInfo<dim>;
  std::vector<std::vector<unsigned int>> edges;
  if constexpr (dim == 2) {
    for (unsigned int v = 0; v < Geometry::vertices_per_cell; ++v)
      if (vertices & (1u << v))
        edges.push_back({v});
  } else
    for (unsigned int l = 0; l < Geometry::lines_per_cell; ++l) {
      const unsigned int v = Geometry::line_to_cell_vertices(l, 0),
                         w = Geometry::line_to_cell_vertices(l, 1);
      if ((vertices & (1u << v)) && (vertices & (1u << w)))
        edges.push_back({v, w});
    }
  return edges;
}

/// The edges of all faces of the named surface on own cells, one after the other.
template <int dim>
std::vector<Edge<dim>> own_edges(const Mesh<dim>& mesh, const DofLayout<dim>& layout,
                                 const BoundaryConditions<dim>& conditions, const std::string& name,
                                 const std::string& place)
{
  std::vector<Edge<dim>> edges;
  std::vector<dealii::types::global_dof_index> indices;
  for (const auto& [entity, vertices] : mesh.surface(name, place)) {
    const auto cell = layout.with_unknowns(entity);
    layout.unknowns(cell, indices);
    for (const std::vector<unsigned int>& corners : corners_of_edges<dim>(vertices)) {
      edges.emplace_back();
      for (const unsigned int v : corners) {
        End<dim> end;
        for (unsigned int c = 0; c < dim; ++c) {
          end.X[c] = entity->vertex(v)[c];
          if (conditions.constraints().is_constrained(
                  indices[*layout.local_dof(cell->active_fe_index(), v, c)]))
            end.given.insert(c);
        }
        edges.back().push_back(end);
      }
      std::sort(edges.back().begin(), edges.back().end());
    }
  }
  return edges;
}

/// The edges of the named surface, those of only one of its faces, on all ranks.
template <int dim>
std::set<Edge<dim>> edges_of(const Mesh<dim>& mesh, const DofLayout<dim>& layout,
                             const BoundaryConditions<dim>& conditions, const std::string& name,
                             const std::string& place)
{
  std::set<Edge<dim>> edges;
  for (const auto& part : dealii::Utilities::MPI::all_gather(
           layout.communicator(), own_edges(mesh, layout, conditions, name, place)))
    for (const Edge<dim>& edge : part)
      if (!edges.insert(edge).second)
        edges.erase(edge);
  return edges;
}

/// Whether neighbouring states move an edge along one line, or in space within a plane that
/// contains it, so that what they sweep is no volume.
template <int dim>
bool has_potential(const Edge<dim>& edge)
{
  std::set<unsigned int> given = edge.front().given;
  if constexpr (dim == 3) {
    std::set<unsigned int> both;
    std::set_intersection(given.begin(), given.end(), edge.back().given.begin(),
                          edge.back().given.end(), std::inserter(both, both.end()));
    given = both;
  }
  double length = 0.;
  for (unsigned int c = 0; c < dim; ++c)
    length = std::hypot(length, edge.front().X[c] - edge.back().X[c]);
  const auto is_flat = [&](const unsigned int c) {
    return std::abs(edge.front().X[c] - edge.back().X[c]) < 1e-9 * length;
  };
  return given.size() + 1 >= dim || std::any_of(given.begin(), given.end(), is_flat);
}

} // namespace

template <int dim>
void check_edges(const Mesh<dim>& mesh, const DofLayout<dim>& layout,
                 const BoundaryConditions<dim>& conditions, const std::string& name,
                 const std::string& place)
{
  for (const Edge<dim>& edge : edges_of(mesh, layout, conditions, name, place))
    if (!has_potential<dim>(edge))
      throw InputError(place + ": an edge of '" + name + "' is free at " +
                       dealii::Patterns::Tools::to_string(edge.front().X) +
                       " mm, so that the pressure has no energy; hold it or support it in its "
                       "symmetry plane");
}

template void check_edges(const Mesh<2>&, const DofLayout<2>&, const BoundaryConditions<2>&,
                          const std::string&, const std::string&);
template void check_edges(const Mesh<3>&, const DofLayout<3>&, const BoundaryConditions<3>&,
                          const std::string&, const std::string&);

} // namespace thelma
