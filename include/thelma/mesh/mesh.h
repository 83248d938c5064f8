#pragma once

#include <thelma/base/parameters.h>
#include <thelma/mesh/cross_section.h>
#include <thelma/mesh/whole_mesh.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/fe/mapping.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace thelma
{

/// The partitioned mesh of a scene, with regions and surfaces known by name. Rank 0 reads it, cuts
/// it up with METIS and deals it out; then every rank has its own cells and their neighbours.
template <int dim>
class Mesh
{
public:
  using CellIterator = typename dealii::Triangulation<dim>::active_cell_iterator;

  /// A face, line or vertex of a cell: bit v is set when the cell's vertex v belongs to it.
  struct Entity {
    CellIterator cell;
    std::uint8_t vertices;
  };

  explicit Mesh(MPI_Comm comm);

  void declare(dealii::ParameterHandler& prm);

  /// The mesh's file, looked up from the working directory, then from @p folder.
  std::string path(const std::string& folder) const { return located(file, folder); }

  using Look = std::function<void(const WholeMesh<dim>&)>;

  /// Rank 0 may @p look at all of it, without its imperfection.
  void read(const std::string& folder, const Look& look = {});

  const CrossSection<dim>& cross_section() const { return section; }

  /// From the reference cell to the undeformed body, for elements of this degree: curved if the
  /// cells are quadratic or their edges arcs and the degree is 2. The mesh must outlive it.
  std::unique_ptr<dealii::Mapping<dim>> mapping(unsigned int degree) const;

  const dealii::Triangulation<dim>& triangulation() const { return tria; }
  MPI_Comm communicator() const { return tria.get_communicator(); }
  dealii::types::global_cell_index n_cells() const { return tria.n_global_active_cells(); }

  /// The place of @p cell, its own or a neighbour, in the order of the whole mesh.
  static unsigned int number_of(const CellIterator& cell)
  {
    return cell->id().get_coarse_cell_id();
  }

  const std::string& region_of(const CellIterator& cell) const
  {
    return table.regions[table.parts[cell->material_id()].region];
  }
  const std::vector<std::string>& regions() const { return table.regions; }

  /// Number of the body that @p cell belongs to; bodies share no vertex.
  unsigned int body_of(const CellIterator& cell) const
  {
    return table.parts[cell->material_id()].body;
  }

  /// The first region of each body.
  std::vector<std::string> bodies() const;

  /// Smallest Jacobian at a vertex over the product of the edges there: 1 in a mesh of boxes.
  double shape() const { return table.worst_shape; }

  /// What it has, and warnings, a sentence each.
  const std::vector<std::string>& remarks() const { return table.remarks; }

  /// A checksum of all vertices and cells.
  std::uint32_t fingerprint() const { return table.fingerprint; }

  /// Faces, lines or points of the named group, on every own cell that has them. Throws InputError,
  /// with @p place in the sentence, when there is no such group or no rank has any.
  const std::vector<Entity>& surface(const std::string& name, const std::string& place) const;
  std::vector<std::string> surface_names() const;

private:
  bool has_arcs() const { return curved != "as meshed"; }
  double size_of_unit() const;
  void distribute(const WholeMesh<dim>& whole);
  void deal_nodes(const WholeMesh<dim>& whole);
  void set_manifold();
  void find_entities();

  CrossSection<dim> section;
  std::string file, unit = "mm", cells = "as meshed", curved = "as meshed";
  std::map<std::string, double> parameters;
  unsigned int refinements = 0;
  double imperfection = 0.; ///< mm
  std::vector<std::string> imperfection_shape;
  MeshTable table;
  std::map<unsigned int, std::vector<dealii::Point<dim>>> quadratic_nodes; ///< by number_of()
  dealii::parallel::fullydistributed::Triangulation<dim> tria;
  std::map<std::string, std::vector<Entity>> surfaces;
};

/// Throws InputError, with the @p place in the sentence, where no region of the @p mesh has the
/// @p name.
template <int dim>
void require_region(const Mesh<dim>& mesh, const std::string& name, const std::string& place);

} // namespace thelma
