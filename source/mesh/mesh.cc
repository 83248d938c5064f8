#include <thelma/base/axes.h>
#include <thelma/base/error.h>
#include <thelma/base/formula.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/mesh/mesh.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <boost/crc.hpp>

#include <algorithm>

namespace thelma
{

template std::uint8_t face_vertices<2>(unsigned int);
template std::uint8_t face_vertices<3>(unsigned int);

namespace
{

using VertexSet = std::vector<unsigned int>;

/// The sets of local vertices that make the faces, lines (3-D) and vertices of a cell.
template <int dim>
std::vector<std::uint8_t> entities_of_a_cell()
{
  using Geometry = dealii::GeometryInfo<dim>;
  std::vector<std::uint8_t> masks;
  for (unsigned int f = 0; f < Geometry::faces_per_cell; ++f)
    masks.push_back(face_vertices<dim>(f));
  if constexpr (dim == 3)
    for (unsigned int l = 0; l < Geometry::lines_per_cell; ++l)
      masks.push_back((1u << Geometry::line_to_cell_vertices(l, 0)) |
                      (1u << Geometry::line_to_cell_vertices(l, 1)));
  for (unsigned int v = 0; v < Geometry::vertices_per_cell; ++v)
    masks.push_back(1u << v);
  return masks;
}

/// Throws InputError unless every face belongs to one cell or two different ones.
template <int dim>
void require_neighbours(const std::vector<dealii::CellData<dim>>& cells)
{
  std::map<VertexSet, std::vector<VertexSet>> cells_of_face;
  for (const dealii::CellData<dim>& cell : cells) {
    VertexSet all(cell.vertices.begin(), cell.vertices.end());
    std::sort(all.begin(), all.end());
    for (unsigned int f = 0; f < dealii::GeometryInfo<dim>::faces_per_cell; ++f) {
      VertexSet face;
      for (unsigned int v = 0; v < dealii::GeometryInfo<dim>::vertices_per_face; ++v)
        face.push_back(cell.vertices[dealii::GeometryInfo<dim>::face_to_cell_vertices(f, v)]);
      std::sort(face.begin(), face.end());
      std::vector<VertexSet>& owners = cells_of_face[face];
      if (owners.size() == 2 || std::find(owners.begin(), owners.end(), all) != owners.end())
        throw InputError(
            "section Mesh, entry 'File': cells lie upon each other, more than two share "
            "a face; every cell belongs to one named region, once");
      owners.push_back(all);
    }
  }
}

} // namespace

template <int dim>
std::uint8_t face_vertices(const unsigned int f)
{
  std::uint8_t mask = 0;
  for (unsigned int v = 0; v < dealii::GeometryInfo<dim>::vertices_per_face; ++v)
    mask |= 1u << dealii::GeometryInfo<dim>::face_to_cell_vertices(f, v);
  return mask;
}

template <int dim>
Mesh<dim>::Mesh(const MPI_Comm comm)
    // Every rank knows every cell, hence all constraints; only its own cells cost it work.
    : tria(comm, dealii::Triangulation<dim>::none, false,
           dealii::parallel::shared::Triangulation<dim>::partition_metis)
{
}

template <int dim>
void Mesh<dim>::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  const Section section(prm, {"Mesh"});
  prm.add_parameter(
      "File", file,
      "A gmsh geometry (.geo) or mesh (.msh) in mm, with named physical groups; looked "
      "up from the working directory, then from the parameter file.",
      Anything());
  add_quantity(prm, "Parameters", parameters,
               "Values for the geometry's parameters, as `L1: 5, n1: 2`; of numbers without unit "
               "too.",
               Quantity("mm"));
  prm.add_parameter("Refinements", refinements,
                    "How often every cell is halved in each direction after meshing.",
                    Integer(0, 20));
  prm.add_parameter("Curved", curved,
                    "Where edges between vertices are arcs: `nowhere`, or all of them `around x2`, "
                    "the axis of a tube, or `around the origin`, the centre of a sphere.",
                    Selection("nowhere|around x2|around the origin"));
  add_quantity(prm, "Imperfection", imperfection,
               "Amplitude of the displacement of the vertices before the calculation starts, so "
               "that the body leaves an unstable straight path.",
               Quantity("mm"));
  prm.add_parameter("Imperfection shape", imperfection_shape,
                    "Its three components as muParser expressions of x1, x2, x3 in mm, as `(1 - "
                    "cos(2*pi*x3/20))/2; 0; 0`; multiplied by the amplitude.",
                    List(Anything(), 0, 3, ";"));
}

template <int dim>
void Mesh<dim>::read(const std::string& folder)
{
  CoarseMesh coarse;
  on_rank_0(tria.get_communicator(),
            [&]() { coarse = read_gmsh(path(folder), parameters, refinements, dim); });
  coarse = dealii::Utilities::MPI::broadcast(tria.get_communicator(), coarse);
  create_triangulation(coarse);
  find_entities(coarse);
}

template <int dim>
void Mesh<dim>::create_triangulation(const CoarseMesh& coarse)
{
  // gmsh counts the vertices of a quadrilateral around it, deal.II row by row.
  const std::array<unsigned int, 8> order{{0, 1, 3, 2, 4, 5, 7, 6}};
  std::vector<dealii::Point<dim>> vertices(coarse.vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (unsigned int d = 0; d < dim; ++d)
      vertices[v][d] = coarse.vertices[v][axis<dim>(d)];

  std::vector<dealii::CellData<dim>> cells;
  for (const PhysicalGroup& group : coarse.groups)
    if (group.dimension == dim) {
      for (const auto& element : group.elements) {
        dealii::CellData<dim> cell;
        for (unsigned int v = 0; v < element.size(); ++v)
          cell.vertices[v] = element[order[v]];
        cell.material_id = region_names.size();
        cells.push_back(cell);
      }
      region_names.push_back(group.name);
    }
  dealii::GridTools::invert_cells_with_negative_measure(vertices, cells);
  check_shapes(vertices, cells, "");
  require_neighbours<dim>(cells);
  dealii::GridTools::consistently_order_cells(cells);
  if (imperfection != 0.) {
    displace(vertices);
    check_shapes(vertices, cells,
                 "section Mesh, entry 'Imperfection': the amplitude of " +
                     dealii::Patterns::Tools::to_string(imperfection) +
                     " mm turns a cell inside out; choose a smaller one or a smoother shape");
  }
  tria.create_triangulation(vertices, cells, dealii::SubCellData());
  if (is_curved()) {
    tria.set_all_manifold_ids(0);
    if constexpr (dim == 2)
      tria.set_manifold(0, dealii::PolarManifold<dim>());
    else if (curved == "around x2")
      tria.set_manifold(0, dealii::CylindricalManifold<dim>(1));
    else
      tria.set_manifold(0, dealii::SphericalManifold<dim>());
  }
}

template <int dim>
void Mesh<dim>::displace(std::vector<dealii::Point<dim>>& vertices) const
{
  const std::string place = "section Mesh, entry 'Imperfection shape'";
  if (imperfection_shape.size() != 3)
    throw InputError(place + ": an imperfection needs three expressions with ';' between them, " +
                     std::to_string(imperfection_shape.size()) + " given");
  const std::vector<dealii::Point<dim>> perfect = vertices;
  for (int c = 0; c < dim; ++c) {
    const Formula<3> shape(place, imperfection_shape[axis<dim>(c)], "x1,x2,x3");
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      dealii::Point<3> X;
      for (int d = 0; d < dim; ++d)
        X[axis<dim>(d)] = perfect[v][d];
      vertices[v][c] += imperfection * shape(X);
    }
  }
}

/// A cell is sound as long as its Jacobian is positive at every vertex. Its shape there is the
/// Jacobian over the product of the lengths of the edges: 1 in a box, 0 where it is flat.
template <int dim>
void Mesh<dim>::check_shapes(const std::vector<dealii::Point<dim>>& vertices,
                             const std::vector<dealii::CellData<dim>>& cells,
                             const std::string& complaint)
{
  constexpr unsigned int n = dealii::GeometryInfo<dim>::vertices_per_cell;
  worst_shape = 1.;
  unsigned int n_bad = 0;
  const dealii::CellData<dim>* bad = nullptr;
  for (const dealii::CellData<dim>& cell : cells) {
    dealii::Point<dim> corners[n];
    dealii::Tensor<0, dim> volumes[n];
    for (unsigned int v = 0; v < n; ++v)
      corners[v] = vertices[cell.vertices[v]];
    dealii::GeometryInfo<dim>::alternating_form_at_vertices(corners, volumes);
    double shape = 1.;
    for (unsigned int v = 0; v < n; ++v) {
      double edges = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        edges *= corners[v].distance(corners[v ^ (1u << d)]);
      shape = std::min(shape, edges > 0. ? double(volumes[v]) / edges : 0.);
    }
    worst_shape = std::min(worst_shape, shape);
    if (!(shape > 1e-6)) {
      ++n_bad;
      bad = bad == nullptr ? &cell : bad;
    }
  }
  if (n_bad > 0)
    throw InputError(!complaint.empty()
                         ? complaint
                         : "section Mesh, entry 'File': " + std::to_string(n_bad) + " of " +
                               std::to_string(cells.size()) +
                               " cells are flat or turned inside out, one of them in the region '" +
                               region_names[bad->material_id] + "' at " +
                               dealii::Patterns::Tools::to_string(vertices[bad->vertices[0]]) +
                               " mm; mend the geometry or its parameters");
}

template <int dim>
void Mesh<dim>::find_entities(const CoarseMesh& coarse)
{
  std::map<VertexSet, std::vector<std::string>> groups_of;
  for (const PhysicalGroup& group : coarse.groups)
    if (group.dimension < dim) {
      surfaces[group.name];
      for (VertexSet element : group.elements) {
        std::sort(element.begin(), element.end());
        groups_of[element].push_back(group.name);
      }
    }

  const std::vector<std::uint8_t> masks = entities_of_a_cell<dim>();
  for (const auto& cell : tria.active_cell_iterators())
    for (const std::uint8_t mask : masks) {
      VertexSet key;
      for (const unsigned int v : cell->vertex_indices())
        if (mask & (1u << v))
          key.push_back(cell->vertex_index(v));
      std::sort(key.begin(), key.end());
      const auto found = groups_of.find(key);
      if (found != groups_of.end())
        for (const std::string& name : found->second)
          surfaces[name].push_back({cell, mask});
    }
}

template <int dim>
std::uint32_t Mesh<dim>::fingerprint() const
{
  boost::crc_32_type sum;
  for (const dealii::Point<dim>& vertex : tria.get_vertices())
    sum.process_bytes(&vertex[0], dim * sizeof(double));
  for (const auto& cell : tria.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices()) {
      const unsigned int index = cell->vertex_index(v);
      sum.process_bytes(&index, sizeof(index));
    }
  return sum.checksum();
}

template <int dim>
const std::vector<typename Mesh<dim>::Entity>& Mesh<dim>::surface(const std::string& name,
                                                                  const std::string& place) const
{
  const auto found = surfaces.find(name);
  if (found == surfaces.end())
    throw InputError(place + ": the mesh has no surface '" + name + "'" +
                     known_ones(name, surface_names()));
  return found->second;
}

template <int dim>
std::vector<std::string> Mesh<dim>::surface_names() const
{
  std::vector<std::string> names;
  for (const auto& entry : surfaces)
    names.push_back(entry.first);
  return names;
}

template class Mesh<2>;
template class Mesh<3>;

} // namespace thelma
