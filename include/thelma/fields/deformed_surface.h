#pragma once

#include <thelma/fields/dof_layout.h>

#include <string>
#include <vector>

namespace thelma
{

/// A named surface of the body, where the deformation has taken it.
template <int dim>
class DeformedSurface
{
public:
  /// Throws InputError, with @p place in the sentence, for an unknown surface and for one inside
  /// the body.
  void setup(const Mesh<dim>& mesh, const DofLayout<dim>& layout, const std::string& name,
             const std::string& place);

  /// A quadrature point of a face.
  struct Point {
    dealii::Point<dim> x;                          ///< deformed, mm
    dealii::Tensor<1, dim> area;                   ///< J F^-T N dA, out of the body, mm^(dim-1)
    double curvature;                              ///< DofLayout::curvature() there
    const std::vector<double>& shape;              ///< N of the face's nodes
    std::vector<dealii::Tensor<1, dim>> gradients; ///< F^-T Grad N of these nodes
  };

  /// A face of an own cell.
  struct Face {
    std::size_t index;               ///< of the cell among the own ones
    const Cell<dim>* cell;           ///< lives as long as the layout
    std::vector<unsigned int> nodes; ///< of the cell on this face

    /// The unknown of @p component at the face's node @p a, among the cell's.
    unsigned int unknown(const unsigned int a, const unsigned int component) const
    {
      return nodes[a] * cell->n_components + component;
    }
  };

  /// Call @p visit(Face, its Points) for the own faces at the displacements in @p x, whose ghosts
  /// are up to date.
  template <typename Visitor>
  void visit(const DofLayout<dim>& layout, const BlockVector& x, const Visitor& visit) const;

  /// Volume (in plane strain per mm) between the own faces and the origin, negative where the body
  /// lies outside (theory.md, eq. 74).
  double own_volume(const DofLayout<dim>& layout, const BlockVector& x) const;

private:
  struct Undeformed {
    double JxW;
    dealii::Point<dim> X;
    dealii::Tensor<1, dim> normal;
    std::vector<double> shape;                     ///< of the face's nodes
    std::vector<dealii::Tensor<1, dim>> gradients; ///< of all of the cell's nodes
  };

  static Point deform(const DofLayout<dim>& layout, const Face& face, const Undeformed& point,
                      const std::vector<double>& values);

  std::vector<Face> faces;
  std::vector<std::vector<Undeformed>> points; ///< of each face
};

template <int dim>
template <typename Visitor>
void DeformedSurface<dim>::visit(const DofLayout<dim>& layout, const BlockVector& x,
                                 const Visitor& visit) const
{
  std::vector<double> values;
  std::vector<Point> deformed;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    layout.gather(*faces[f].cell, x, values);
    deformed.clear();
    for (const Undeformed& point : points[f])
      deformed.push_back(deform(layout, faces[f], point, values));
    visit(faces[f], deformed);
  }
}

} // namespace thelma
