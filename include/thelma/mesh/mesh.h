#pragma once

#include <thelma/base/parameters.h>
#include <thelma/mesh/gmsh_reader.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/distributed/shared_tria.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace thelma
{

/// The vertices of face @p f of a cell, as bits.
template <int dim>
std::uint8_t face_vertices(unsigned int f);

/// The partitioned mesh of a scene, with regions and surfaces known by name.
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

  void read(const std::string& folder);

  /// Whether the edges of cells are arcs, so that quadratic elements need a quadratic geometry.
  bool is_curved() const { return curved != "nowhere"; }

  const dealii::parallel::shared::Triangulation<dim>& triangulation() const { return tria; }

  const std::string& region_of(const CellIterator& cell) const
  {
    return region_names[cell->material_id()];
  }
  const std::vector<std::string>& regions() const { return region_names; }

  /// Smallest Jacobian at a vertex over the product of the edges there: 1 in a mesh of boxes.
  double shape() const { return worst_shape; }

  /// A checksum of all vertices and cells.
  std::uint32_t fingerprint() const;

  /// Faces, lines or points of the named group, on every cell that has them.
  /// Throws InputError, with @p place in the sentence, when there is no such group.
  const std::vector<Entity>& surface(const std::string& name, const std::string& place) const;
  std::vector<std::string> surface_names() const;

private:
  void create_triangulation(const CoarseMesh& coarse);
  void displace(std::vector<dealii::Point<dim>>& vertices) const;
  void check_shapes(const std::vector<dealii::Point<dim>>& vertices,
                    const std::vector<dealii::CellData<dim>>& cells, const std::string& complaint);
  void find_entities(const CoarseMesh& coarse);

  std::string file, curved = "nowhere";
  std::map<std::string, double> parameters;
  unsigned int refinements = 0;
  double imperfection = 0.; ///< mm
  double worst_shape = 1.;
  std::vector<std::string> imperfection_shape;
  dealii::parallel::shared::Triangulation<dim> tria;
  std::vector<std::string> region_names;
  std::map<std::string, std::vector<Entity>> surfaces;
};

} // namespace thelma
