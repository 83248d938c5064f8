#pragma once

#include <thelma/mesh/cell_shapes.h>
#include <thelma/mesh/gmsh_reader.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace thelma
{

/// What every rank knows of a mesh, of which it has only some cells.
struct MeshTable {
  /// The part of a region that belongs to one body; bodies share no vertex.
  struct Part {
    unsigned int region, body;

    template <class Archive>
    void serialize(Archive& archive, unsigned int)
    {
      archive& region& body;
    }
  };

  /// A face, line or vertex: bit v is set when vertex v of the cell of this number belongs to it.
  struct Place {
    unsigned int cell;
    std::uint8_t vertices;

    template <class Archive>
    void serialize(Archive& archive, unsigned int)
    {
      archive& cell& vertices;
    }
  };

  std::vector<std::string> regions;
  std::vector<Part> parts;                            ///< by the material id of their cells
  std::map<std::string, std::vector<Place>> surfaces; ///< and lines and points, on all their cells
  std::vector<std::string> remarks;                   ///< sentences for the user
  double worst_shape = 1.; ///< smallest Jacobian at a vertex over the product of the edges there
  std::uint32_t fingerprint = 0; ///< a checksum of all vertices, cells, regions and surfaces

  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& regions& parts& surfaces& remarks& worst_shape& fingerprint;
  }
};

/// All cells of a mesh, in the order that gives them their numbers. Only the rank that reads them
/// has them, until they are dealt out.
template <int dim>
class WholeMesh
{
public:
  WholeMesh() = default;

  /// Throws InputError unless every cell is sound and has its neighbours.
  explicit WholeMesh(const CoarseMesh& coarse);

  /// Move vertices from their x1, x2, x3 (mm) by the amplitude (mm) times these expressions. Throws
  /// InputError when a cell turns inside out.
  void displace(double amplitude, const std::vector<std::string>& expressions);

  /// To be called last.
  MeshTable table() const;

  const std::string& region_of_part(const unsigned int part) const
  {
    return known.regions[known.parts[part].region];
  }
  unsigned int body_of_part(const unsigned int part) const { return known.parts[part].body; }
  unsigned int n_bodies() const;

  /// Smallest Jacobian at a vertex, or a node, over the product of the edges there.
  double shape_of(const dealii::CellData<dim>& cell) const;

  /// Whether some edge is not straight.
  bool is_quadratic() const { return !middles.empty(); }

  /// All nodes of a quadratic @p cell, in the order of a Lagrange element of degree 2.
  std::vector<dealii::Point<dim>> nodes_of(const dealii::CellData<dim>& cell) const
  {
    return quadratic_nodes(cell, vertices, middles);
  }

  std::vector<dealii::Point<dim>> vertices; ///< in mm
  std::vector<dealii::CellData<dim>> cells; ///< their material is the number of the part

private:
  void find_middles(const CoarseMesh& coarse);
  void find_bodies();
  void find_surfaces(const CoarseMesh& coarse);
  void check_shapes(const std::string& complaint);
  std::uint32_t fingerprint() const;

  Middles<dealii::Point<dim>> middles;
  MeshTable known;
};

/// A warning, as a sentence, for all that lies together in space but not in the mesh.
template <int dim>
std::vector<std::string> contacts(const WholeMesh<dim>& mesh);

/// Throws InputError unless every edge is an arc @p around an axis, as `around x2`, or `around the
/// origin`, or leads away from that.
template <int dim>
void require_arcs(const WholeMesh<dim>& mesh, const std::string& around);

/// The text of a VTU file: cells with region, body and shape, and the cells of every named group.
template <int dim>
std::string picture(const WholeMesh<dim>& mesh);

} // namespace thelma
