#include <thelma/base/error.h>
#include <thelma/base/quantity.h>
#include <thelma/base/units.h>
#include <thelma/mesh/mesh.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unordered_map>

namespace thelma
{
namespace
{

/// Of a body of revolution.
template <int dim>
void require_half_plane(const WholeMesh<dim>& whole)
{
  double least = 0., size = 0.;
  for (const dealii::Point<dim>& X : whole.vertices) {
    least = std::min(least, X[0]);
    size = std::max(size, std::abs(X[0]));
  }
  if (least < -1e-9 * size)
    throw InputError("section Mesh, entry 'File': the mesh has a vertex at x1 = " + as_text(least) +
                     " mm, but x1 is the radius of an axisymmetric body; keep the half of the "
                     "section where x1 >= 0, or set Geometry = plane strain");
}

} // namespace

template <int dim>
Mesh<dim>::Mesh(const MPI_Comm comm) : tria(comm)
{
}

template <int dim>
void Mesh<dim>::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  section.declare(prm);
  const Section in_mesh(prm, {"Mesh"});
  prm.add_parameter(
      "File", file,
      "A gmsh geometry (.geo) or mesh (.msh) with named physical groups; the path is relative to "
      "the working directory or else to the parameter file. A .geo merges other geometries, such "
      "as `Merge \"part.step\";`, and names their parts. Cells of order 2 are curved where "
      "elements are of degree 2.",
      Anything());
  prm.add_parameter(
      "Unit", unit,
      "Of the lengths in a .msh, such as m or um. A .geo in another unit than mm says "
      "so itself, `Mesh.ScalingFactor = 1000;` for m.",
      Anything());
  prm.add_parameter("Cells", cells,
                    "Those of the geometry, quadrilaterals or hexahedra, `as meshed`; or, of any "
                    "shape that gmsh meshes, `subdivided`: triangles are cut into quadrilaterals, "
                    "tetrahedra into four hexahedra, half as large as the geometry says.",
                    Selection("as meshed|subdivided"));
  add_quantity(prm, "Parameters", parameters,
               "Values of the geometry's parameters, such as `L1: 5, n1: 2`, dimensionless ones "
               "included.",
               Quantity("mm"));
  prm.add_parameter("Refinements", refinements,
                    "Number of times that every cell is halved in each direction after meshing.",
                    Integer(0, 20));
  prm.add_parameter("Curved", curved,
                    "Whether edges between vertices are arcs: `as meshed`, which is straight in "
                    "cells of order 1, or all of them `around x2`, the axis of a tube (in 3-D also "
                    "x1 or x3), or `around the origin`, the centre of a sphere. Radial edges are "
                    "straight.",
                    Selection("as meshed|around x1|around x2|around x3|around the origin"));
  add_quantity(prm, "Imperfection", imperfection,
               "Amplitude of the initial displacement of the vertices, a geometric imperfection "
               "that makes the body leave an unstable straight path.",
               Quantity("mm"));
  prm.add_parameter("Imperfection shape", imperfection_shape,
                    "Its three components as muParser expressions of x1, x2, x3 in mm, such as `(1 "
                    "- cos(2*pi*x3/20))/2; 0; 0`; multiplied by the amplitude.",
                    List(Anything(), 0, 3, ";"));
}

template <int dim>
void Mesh<dim>::read(const std::string& folder, const Look& look)
{
  if (file.empty())
    throw InputError("section Mesh, entry 'File': it is empty or missing; write `set File = "
                     "NAME.geo`");
  if (dim == 3 && section.is_axisymmetric())
    throw InputError("entry 'Geometry': a scene in space is no section; remove the entry, or set "
                     "Dimension = 2 and give half a section through the body");
  if (dim == 2 && (curved == "around x1" || curved == "around x3"))
    throw InputError("section Mesh, entry 'Curved': in the x1-x3 plane arcs are " +
                     std::string("`around x2`, not `") + curved + "`");
  WholeMesh<dim> whole;
  on_rank_0(communicator(), [&]() {
    const std::string around = has_arcs() ? curved.substr(std::string("around ").size()) : "";
    whole = WholeMesh<dim>(read_gmsh(
        {path(folder), parameters, size_of_unit(), cells == "subdivided", refinements, around},
        dim));
    if (look)
      look(whole);
    if (has_arcs())
      require_arcs(whole, curved);
    if (imperfection != 0. || !imperfection_shape.empty())
      whole.displace(imperfection, imperfection_shape);
    if (section.is_axisymmetric())
      require_half_plane(whole);
    table = whole.table();
  });
  table = dealii::Utilities::MPI::broadcast(communicator(), table);
  distribute(whole);
  deal_nodes(whole);
  find_entities();
}

/// In mm.
template <int dim>
double Mesh<dim>::size_of_unit() const
{
  const Unit mm = *Unit::parse("mm");
  const std::optional<Unit> found = Unit::parse(unit);
  if (!found || found->dimension != mm.dimension)
    throw InputError("section Mesh, entry 'Unit': '" + unit +
                     "' is not a unit of length; write mm, m or um");
  if (found->factor != mm.factor && std::filesystem::path(file).extension() != ".msh")
    throw InputError("section Mesh, entry 'Unit': '" + file +
                     "' is a geometry, which says its unit itself; write `Mesh.ScalingFactor = " +
                     as_text(found->factor / mm.factor) + ";` there and remove this entry");
  return found->factor / mm.factor;
}

/// Every rank asks the first for the nodes of its cells and their neighbours, if they are
/// quadratic.
template <int dim>
void Mesh<dim>::deal_nodes(const WholeMesh<dim>& whole)
{
  using namespace dealii::Utilities::MPI;
  if (!broadcast(communicator(), whole.is_quadratic()))
    return;
  std::vector<unsigned int> numbers;
  for (const auto& cell : tria.active_cell_iterators())
    if (!cell->is_artificial())
      numbers.push_back(number_of(cell));
  const auto asked = gather(communicator(), numbers);
  std::map<unsigned int, std::vector<std::vector<dealii::Point<dim>>>> answers;
  for (unsigned int rank = 0; rank < asked.size(); ++rank)
    for (const unsigned int number : asked[rank])
      answers[rank].push_back(whole.nodes_of(whole.cells[number]));
  const auto received = some_to_some(communicator(), answers);
  for (unsigned int i = 0; i < numbers.size(); ++i)
    quadratic_nodes.emplace(numbers[i], received.at(0)[i]);
}

template <int dim>
std::unique_ptr<dealii::Mapping<dim>> Mesh<dim>::mapping(const unsigned int degree) const
{
  if (quadratic_nodes.empty() || degree == 1)
    return std::make_unique<dealii::MappingQ<dim>>(has_arcs() ? degree : 1);
  auto result = std::make_unique<dealii::MappingQCache<dim>>(2);
  const dealii::FE_Q<dim> element(2);
  result->initialize(tria, [&](const typename dealii::Triangulation<dim>::cell_iterator& cell) {
    const auto known = quadratic_nodes.find(number_of(cell));
    if (known != quadratic_nodes.end())
      return known->second;
    std::vector<dealii::Point<dim>> straight; // another rank's, which nobody looks at
    for (const dealii::Point<dim>& x : element.get_unit_support_points())
      straight.push_back(
          dealii::StaticMappingQ1<dim>::mapping.transform_unit_to_real_cell(cell, x));
    return straight;
  });
  return result;
}

template <int dim>
void Mesh<dim>::distribute(const WholeMesh<dim>& whole)
{
  using namespace dealii;
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator());
  const auto create = [&](Triangulation<dim>& serial) {
    serial.create_triangulation(whole.vertices, whole.cells, SubCellData());
    if (has_arcs())
      serial.set_all_manifold_ids(0);
  };
  const auto partition = [&](Triangulation<dim>& serial, const MPI_Comm&, unsigned int) {
    GridTools::partition_triangulation(n_ranks, serial, SparsityTools::Partitioner::metis);
  };
  const auto description =
      TriangulationDescription::Utilities::create_description_from_triangulation_in_groups<dim,
                                                                                           dim>(
          create, partition, communicator(), n_ranks);
  if (has_arcs())
    set_manifold();
  tria.create_triangulation(description);
}

template <int dim>
void Mesh<dim>::set_manifold()
{
  if constexpr (dim == 2)
    tria.set_manifold(0, dealii::PolarManifold<dim>());
  else if (curved == "around the origin")
    tria.set_manifold(0, dealii::SphericalManifold<dim>());
  else
    tria.set_manifold(0, dealii::CylindricalManifold<dim>(curved.back() - '1'));
}

template <int dim>
void Mesh<dim>::find_entities()
{
  std::unordered_map<unsigned int, CellIterator> own;
  for (const auto& cell : tria.active_cell_iterators())
    if (cell->is_locally_owned())
      own.emplace(number_of(cell), cell);
  for (auto& [name, places] : table.surfaces) {
    std::vector<Entity>& entities = surfaces[name];
    for (const MeshTable::Place& place : places)
      if (const auto cell = own.find(place.cell); cell != own.end())
        entities.push_back({cell->second, place.vertices});
  }
}

template <int dim>
std::vector<std::string> Mesh<dim>::bodies() const
{
  std::vector<std::string> regions;
  for (const MeshTable::Part& part : table.parts)
    if (part.body == regions.size())
      regions.push_back(table.regions[part.region]);
  return regions;
}

template <int dim>
const std::vector<typename Mesh<dim>::Entity>& Mesh<dim>::surface(const std::string& name,
                                                                  const std::string& place) const
{
  if (name.empty())
    throw InputError(place + ": it is empty or missing; write one of " +
                     comma_separated(surface_names()));
  const auto found = surfaces.find(name);
  if (found == surfaces.end())
    throw InputError(place + ": the mesh has no surface '" + name + "'" +
                     did_you_mean(name, surface_names()));
  if (table.surfaces.at(name).empty())
    throw InputError(place + ": surface '" + name + "' touches no cell");
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

template <int dim>
void require_region(const Mesh<dim>& mesh, const std::string& name, const std::string& place)
{
  const std::vector<std::string>& regions = mesh.regions();
  if (std::find(regions.begin(), regions.end(), name) == regions.end())
    throw InputError(place + ": the mesh has no region '" + name + "'" +
                     did_you_mean(name, regions));
}

template class Mesh<2>;
template class Mesh<3>;
template void require_region(const Mesh<2>&, const std::string&, const std::string&);
template void require_region(const Mesh<3>&, const std::string&, const std::string&);

} // namespace thelma
