#include <thelma/base/axes.h>
#include <thelma/base/error.h>
#include <thelma/fields/rigid_motions.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <numeric>

namespace thelma
{
namespace
{

/// The root of a tree of vertices, with the way to it made short.
unsigned int root(std::vector<unsigned int>& parent, unsigned int v)
{
  while (parent[v] != v)
    v = parent[v] = parent[parent[v]];
  return v;
}

template <int dim>
constexpr unsigned int n_motions = dim == 3 ? 6 : 3;

/// Displacement @p c at @p X of each rigid motion: along every direction, then about x1, x2, x3 (in
/// the plane about x2).
template <int dim>
std::array<double, n_motions<dim>> rigid_displacement(const dealii::Point<dim>& X,
                                                      const unsigned int c)
{
  std::array<double, n_motions<dim>> u{};
  u[c] = 1.;
  if constexpr (dim == 2)
    u[2] = c == 0 ? X[1] : -X[0];
  else
    for (unsigned int a = 0; a < 3; ++a) // e_a x X
      u[3 + a] = c == (a + 1) % 3 ? -X[(a + 2) % 3] : c == (a + 2) % 3 ? X[(a + 1) % 3] : 0.;
  return u;
}

template <int dim>
std::string motion_name(const unsigned int m)
{
  if (m < dim)
    return "move along x" + std::to_string(axis<dim>(m) + 1);
  return "turn about x" + std::to_string(dim == 2 ? 2 : m - 2);
}

} // namespace

template <int dim>
RigidMotions<dim>::RigidMotions(const Mesh<dim>& mesh)
    : mesh(mesh), body_of_vertex(mesh.triangulation().n_vertices())
{
  std::iota(body_of_vertex.begin(), body_of_vertex.end(), 0);
  for (const auto& cell : mesh.triangulation().active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      body_of_vertex[root(body_of_vertex, cell->vertex_index(v))] =
          root(body_of_vertex, cell->vertex_index(0));
  std::vector<int> number(body_of_vertex.size(), -1);
  for (const auto& cell : mesh.triangulation().active_cell_iterators())
    if (int& body = number[root(body_of_vertex, cell->vertex_index(0))]; body < 0) {
      body = bodies.size();
      bodies.push_back({mesh.region_of(cell), cell->center(), {}});
    }
  for (unsigned int v = 0; v < number.size(); ++v)
    if (root(body_of_vertex, v) != v)
      number[v] = number[root(body_of_vertex, v)];
  body_of_vertex.assign(number.begin(), number.end());
}

template <int dim>
void RigidMotions<dim>::hold(const std::string& surface, const unsigned int component)
{
  for (const auto& [cell, vertices] : mesh.surface(surface, ""))
    for (const unsigned int v : cell->vertex_indices())
      if (vertices & (1u << v))
        bodies[body_of_vertex[cell->vertex_index(v)]].held.emplace_back(cell->vertex(v), component);
}

/// A motion that all held displacements are blind to is in the kernel of the sum of their squares.
template <int dim>
std::vector<std::string> RigidMotions<dim>::free_motions(const Body& body)
{
  constexpr unsigned int n = n_motions<dim>;
  double size = 0.;
  for (const Held& held : body.held)
    size = std::max(size, held.first.distance(body.centre));
  dealii::LAPACKFullMatrix<double> squares(n, n);
  for (const auto& [X, c] : body.held) {
    const auto u =
        rigid_displacement<dim>(dealii::Point<dim>((X - body.centre) / (size > 0. ? size : 1.)), c);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        squares(i, j) += u[i] * u[j] / body.held.size();
  }
  squares.compute_svd();
  std::vector<std::string> motions;
  for (unsigned int k = 0; k < n; ++k)
    if (squares.singular_value(k) < 1e-12) {
      unsigned int largest = 0;
      for (unsigned int m = 0; m < n; ++m)
        if (std::abs(squares.get_svd_vt()(k, m)) >
            (1. + 1e-6) * std::abs(squares.get_svd_vt()(k, largest)))
          largest = m;
      const std::string name = motion_name<dim>(largest);
      if (std::find(motions.begin(), motions.end(), name) == motions.end())
        motions.push_back(name);
    }
  return motions;
}

template <int dim>
std::vector<std::string> RigidMotions<dim>::remaining() const
{
  std::vector<std::string> sentences;
  for (const Body& body : bodies)
    if (const std::vector<std::string> motions = free_motions(body); !motions.empty())
      sentences.push_back("the body with region '" + body.region + "' floats, it can " +
                          comma_separated(motions) +
                          "; fix more components of its surfaces, lines or points" +
                          (bodies.size() > 1 ? ", or join it to another body" : ""));
  return sentences;
}

template class RigidMotions<2>;
template class RigidMotions<3>;

} // namespace thelma
