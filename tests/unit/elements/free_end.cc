// What becomes unstable in the bending actuator on the paper's mesh (doc/elements.md).

#include "scene.h"

#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <thelma/solvers/mumps.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace thelma_test;

/// The most unstable displacement (of size 1) and its eigenvalue: Lanczos' method for the inverse
/// of K_uu - K_uphi K_phiphi^-1 K_phiu, which is the u-part of the inverse of the tangent.
std::pair<double, BlockVector> most_unstable_mode(TestScene<3>& scene)
{
  constexpr unsigned int n = 80;
  Mumps solver(MPI_COMM_WORLD, true);
  scene.system.linear.assemble();
  EXPECT_TRUE(solver.factorise(scene.system.linear.matrix()).solved);
  std::vector<BlockVector> basis;
  dealii::LAPACKFullMatrix<double> H(n, n);
  BlockVector v = scene.layout.new_vector();
  add_noise(scene, {1., 0.}, v);
  for (unsigned int k = 0; k < n; ++k) {
    v /= v.l2_norm();
    basis.push_back(v);
    EXPECT_TRUE(solver.solve(v).solved);
    scene.conditions.constraints().set_zero(v);
    v.block(1) = 0.;
    for (int pass = 0; pass < 2; ++pass)
      for (unsigned int i = 0; i <= k; ++i) {
        const double h = basis[i] * v;
        H(i, k) += h;
        v.add(-h, basis[i]);
      }
    if (k + 1 < n)
      H(k + 1, k) = v.l2_norm();
  }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < i; ++j)
      H(i, j) = H(j, i);
  dealii::Vector<double> values;
  dealii::FullMatrix<double> vectors;
  H.compute_eigenvalues_symmetric(-1e30, 0., 1e-14, values, vectors);
  BlockVector mode = scene.layout.new_vector();
  for (unsigned int i = 0; i < n && values.size() > 0; ++i)
    mode.add(vectors(i, 0), basis[i]);
  mode.update_ghost_values();
  return {values.size() > 0 ? 1. / values[0] : 0., mode};
}

/// The bending actuator at 353 K on the paper's mesh at e, reached in steps.
void solve_bending(TestScene<3>& scene, const double from, const double to)
{
  constexpr double per_e = 10.5325 / 0.87; // kV
  const auto n_steps = std::lround((to - from) / 0.02);
  for (long step = 1; step <= n_steps; ++step) {
    const double e = from + 0.02 * static_cast<double>(step);
    scene.apply_voltage(e * per_e);
    const NewtonReport report = Newton().solve(scene.system);
    ASSERT_TRUE(report.converged) << e << ' ' << report.reason;
  }
}

/// What becomes unstable near e = 0.72 is no hourglass: the free end, whose width is held while
/// heat and field would widen it, buckles in one half-wave across the width.
TEST(BendingActuator, FreeEndBuckles)
{
  TestScene<3> scene(
      "subsection Mesh\n set File = meshes/bilayer.geo\nend\n"
      "subsection Regions\n set Materials = active: elastomer, passive: elastomer\n"
      " set Passive = passive\nend\nsubsection Materials\n subsection elastomer\n"
      "  set Thermal expansion = 1.8e-4\n end\nend\n"
      "subsection Discretisation\n set Formulation = mean dilatation\nend\n"
      "subsection Supports\n set Fixed = x3_min: u3, x2_min: u2, x2_max: u2, pin: u1\nend\n"
      "subsection Electrodes\n set Potential = interface: 0, outer: 1\nend\n",
      353.);
  solve_bending(scene, -0.02, 0.7);
  EXPECT_EQ(most_unstable_mode(scene).first, 0.);
  solve_bending(scene, 0.7, 0.74);
  const auto [eigenvalue, mode] = most_unstable_mode(scene);
  EXPECT_LT(eigenvalue, 0.);

  double whole = 0., end = 0.;                    // squares of u_1, everywhere and near the end
  double edge = 0., half_wave = 0., product = 0.; // and on the end face, with cos(pi x2/W)
  const auto& points = scene.layout.scalar_element().get_unit_support_points();
  for (const Cell<3>& cell : scene.layout.cells())
    for (std::size_t a = 0; a < points.size(); ++a) {
      const dealii::Point<3> X =
          dealii::MappingQ1<3>().transform_unit_to_real_cell(cell.iterator, points[a]);
      const double u1 = mode(cell.dofs[a * cell.n_components]);
      const double wave = std::cos(M_PI * X[1] / 4.);
      whole += u1 * u1;
      if (X[2] > 14.5)
        end += u1 * u1;
      if (X[2] > 19.5) {
        edge += u1 * u1;
        half_wave += wave * wave;
        product += u1 * wave;
      }
    }
  const double likeness = product * product / (edge * half_wave);
  std::printf(
      "eigenvalue %.2e N/mm; %.3f of u_1 in the last quarter, %.4f of it there half a wave\n",
      eigenvalue, end / whole, likeness);
  EXPECT_GT(likeness, 0.9);
  EXPECT_GT(end / whole, 0.9);
}

} // namespace
