// Whether the edges of a curved mesh are arcs.

#include <thelma/base/axes.h>
#include <thelma/base/error.h>
#include <thelma/mesh/whole_mesh.h>

#include <deal.II/base/patterns.h>

namespace thelma
{
namespace
{

/// From the axis or the origin to @p x.
template <int dim>
dealii::Tensor<1, dim> radius(const dealii::Point<dim>& x, const std::string& around)
{
  dealii::Tensor<1, dim> r = x;
  for (int d = 0; d < dim; ++d)
    if (around == "around x" + std::to_string(axis<dim>(d) + 1))
      r[d] = 0.;
  return r;
}

} // namespace

template <int dim>
void require_arcs(const WholeMesh<dim>& mesh, const std::string& around)
{
  constexpr double rounding = 1e-4; // of a radius, and of an angle
  const std::string place = "section Mesh, entry 'Curved': ";
  const auto at = [](const dealii::Point<dim>& x) {
    return dealii::Patterns::Tools::to_string(x) + " mm";
  };
  using Geometry = dealii::GeometryInfo<dim>;
  for (const dealii::CellData<dim>& cell : mesh.cells)
    for (unsigned int l = 0; l < Geometry::lines_per_cell; ++l) {
      const dealii::Point<dim>&from =
                mesh.vertices[cell.vertices[Geometry::line_to_cell_vertices(l, 0)]],
            &to = mesh.vertices[cell.vertices[Geometry::line_to_cell_vertices(l, 1)]];
      const dealii::Tensor<1, dim> a = radius(from, around), b = radius(to, around);
      const double r = a.norm(), R = b.norm();
      if (std::min(r, R) <= rounding * std::max(r, R))
        throw InputError(place + "the node at " + at(r < R ? from : to) +
                         " is at the centre of the arcs " + around +
                         "; leave a hole there, or write `as meshed`");
      if (std::abs(R - r) > rounding * R && (a / r - b / R).norm() > rounding)
        throw InputError(place + "the edge from " + at(from) + " to " + at(to) + " is not an arc " +
                         around + ", because its ends have the radii " + as_text(r) + " and " +
                         as_text(R) + "; align the cells with arcs, or write `as meshed`");
    }
}

template void require_arcs(const WholeMesh<2>&, const std::string&);
template void require_arcs(const WholeMesh<3>&, const std::string&);

} // namespace thelma
