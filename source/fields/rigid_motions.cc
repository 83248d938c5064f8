#include <thelma/base/axes.h>
#include <thelma/base/error.h>
#include <thelma/fields/rigid_motions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>

namespace thelma
{
namespace
{

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

/// Whether the motion @p m is none of a body of revolution as such, which can only move along its
/// axis.
template <int dim>
bool strains(const Mesh<dim>& mesh, const unsigned int m)
{
  return mesh.cross_section().is_axisymmetric() && m != 1;
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
void RigidMotions<dim>::hold(const std::string& surface, const unsigned int component)
{
  for (const auto& [cell, vertices] : mesh.surface(surface, ""))
    for (const unsigned int v : cell->vertex_indices())
      if (vertices & (1u << v))
        own.push_back({mesh.body_of(cell), component, cell->vertex(v)});
}

/// A motion that all held displacements are blind to is in the kernel of the sum of their squares.
template <int dim>
std::vector<std::string> RigidMotions<dim>::free_motions(const std::vector<Held>& body) const
{
  constexpr unsigned int n = n_motions<dim>;
  double size = 0.;
  for (const Held& held : body)
    size = std::max(size, held.X.distance(body.front().X));
  dealii::LAPACKFullMatrix<double> squares(n, n);
  for (const Held& held : body) {
    const auto u = rigid_displacement<dim>(
        dealii::Point<dim>((held.X - body.front().X) / (size > 0. ? size : 1.)), held.component);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        squares(i, j) += u[i] * u[j] / body.size();
  }
  for (unsigned int m = 0; m < n; ++m)
    squares(m, m) += strains(mesh, m) ? 1. : 0.;
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
  const std::vector<std::string> regions = mesh.bodies();
  std::vector<std::vector<Held>> bodies(regions.size());
  for (const std::vector<Held>& part : dealii::Utilities::MPI::all_gather(mesh.communicator(), own))
    for (const Held& held : part)
      bodies[held.body].push_back(held);
  std::vector<std::string> sentences;
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (const std::vector<std::string> motions = free_motions(bodies[k]); !motions.empty())
      sentences.push_back("the body with region '" + regions[k] + "' floats, it can " +
                          comma_separated(motions) +
                          "; fix more components of its surfaces, lines or points" +
                          (bodies.size() > 1 ? ", or join it to another body" : ""));
  return sentences;
}

template class RigidMotions<2>;
template class RigidMotions<3>;

} // namespace thelma
