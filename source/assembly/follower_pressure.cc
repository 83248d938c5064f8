#include <thelma/assembly/follower_pressure.h>
#include <thelma/base/complaints.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>

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

const std::string pressure_entry = "section Loads, entry 'Pressure'";

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
std::vector<Edge<dim>> own_edges(const Mesh<dim>& mesh, const FieldLayout<dim>& layout,
                                 const BoundaryConditions<dim>& conditions, const std::string& name)
{
  std::vector<Edge<dim>> edges;
  std::vector<dealii::types::global_dof_index> indices;
  for (const auto& [entity, vertices] : mesh.surface(name, pressure_entry)) {
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
std::set<Edge<dim>> edges_of(const Mesh<dim>& mesh, const FieldLayout<dim>& layout,
                             const BoundaryConditions<dim>& conditions, const std::string& name)
{
  std::set<Edge<dim>> edges;
  for (const auto& part : dealii::Utilities::MPI::all_gather(
           layout.communicator(), own_edges(mesh, layout, conditions, name)))
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

template <int dim>
[[noreturn]] void refuse(const std::string& name, const Edge<dim>& edge)
{
  throw InputError(pressure_entry + ": an edge of '" + name + "' is free at " +
                   dealii::Patterns::Tools::to_string(edge.front().X) +
                   " mm, so that the pressure has no energy; hold it or support it in its symmetry "
                   "plane");
}

} // namespace

template <int dim>
void FollowerPressure<dim>::declare(dealii::ParameterHandler& prm)
{
  const Section section(prm, {"Loads"});
  add_quantity(prm, "Pressure", values,
               "Pressures on surfaces, to which the stage `pressure` (Loading/Stages) goes, as "
               "`inner: 0.002`. They act on the deformed surface and stay normal to it. The edges "
               "of the surface must lie in symmetry planes or be held.",
               Quantity("MPa"));
}

template <int dim>
void FollowerPressure<dim>::setup(const Mesh<dim>& mesh, const FieldLayout<dim>& fields,
                                  const BoundaryConditions<dim>& conditions)
{
  layout = &fields;
  Complaints complaints;
  for (const auto& [name, pressure] : values)
    complaints.allow([&, &name = name, &pressure = pressure]() {
      surfaces.push_back({pressure, {}});
      surfaces.back().surface.setup(mesh, fields, name, pressure_entry);
      for (const auto& edge : edges_of(mesh, fields, conditions, name))
        if (!has_potential<dim>(edge))
          refuse<dim>(name, edge);
    });
  complaints.raise();
}

/// Eq. (49).
template <int dim>
void FollowerPressure<dim>::add_full_forces(const double scale, const BlockVector& x,
                                            BlockVector& nodal) const
{
  for (const Loaded& loaded : surfaces) {
    const double pressure = scale * loaded.pressure;
    loaded.surface.visit(*layout, x, [&](const auto& face, const auto& points) {
      for (const auto& point : points)
        for (std::size_t a = 0; a < face.nodes.size(); ++a)
          for (unsigned int i = 0; i < dim; ++i)
            nodal(face.cell->dofs[face.unknown(a, i)]) -= pressure * point.shape[a] * point.area[i];
    });
  }
}

/// Eq. (51).
template <int dim>
void FollowerPressure<dim>::add_tangent(const BlockVector& x, TangentMatrix<dim>& tangent) const
{
  std::vector<double> entries;
  for (const Loaded& loaded : surfaces) {
    const double half = factor * loaded.pressure / 2.;
    loaded.surface.visit(*layout, x, [&](const auto& face, const auto& points) {
      const std::size_t n = face.cell->dofs.size();
      entries.assign(n * n, 0.);
      for (const auto& point : points)
        for (std::size_t a = 0; a < face.nodes.size(); ++a)
          for (std::size_t b = 0; b < face.nodes.size(); ++b) {
            const dealii::Tensor<1, dim> mixed =
                point.shape[a] * point.gradients[b] - point.shape[b] * point.gradients[a];
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                entries[face.unknown(a, i) * n + face.unknown(b, j)] +=
                    half * (mixed[j] * point.area[i] - mixed[i] * point.area[j]);
          }
      tangent.add(face.index, *face.cell, entries);
    });
  }
}

template class FollowerPressure<2>;
template class FollowerPressure<3>;

} // namespace thelma
