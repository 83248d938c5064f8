// When each element formulation fails (doc/elements.md), in the smallest case that shows it. The
// truth is the continuum: neo-Hookean rubber of constant volume is elliptic at every stretch.

#include "scene.h"

#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>

#include <functional>

namespace
{

using namespace thelma_test;

constexpr double mu = 0.056552; // MPa at 293 K

/// A square of 2 x 2 mm in plane strain without a field, in n x n cells.
std::string square(const std::string& formulation, const int degree, const int n,
                   const std::string& fixed)
{
  const std::string cells = std::to_string(n);
  return "subsection Mesh\n set File = meshes/bilayer_plane.geo\n set Parameters = L: 2, H: 2, "
         "n1: " +
         cells + ", n3: " + cells +
         "\nend\nsubsection Regions\n set Materials = active: elastomer, passive: elastomer\n"
         " set Passive = active, passive\nend\nsubsection Discretisation\n set Degree = " +
         std::to_string(degree) + "\n set Formulation = " + formulation +
         "\nend\nsubsection Supports\n set Fixed = " + fixed + "\nend\n";
}

const char* const held = "outer: u1 u3, back: u1 u3, x3_min: u1 u3, x3_max: u1 u3";

/// Set u(X) at every node.
void displace(TestScene<2>& scene,
              const std::function<dealii::Point<2>(const dealii::Point<2>&)>& u)
{
  const auto& points = scene.layout.scalar_element().get_unit_support_points();
  for (const Cell<2>& cell : scene.layout.cells())
    for (unsigned int a = 0; a < points.size(); ++a) {
      const dealii::Point<2> value =
          u(dealii::MappingQ1<2>().transform_unit_to_real_cell(cell.iterator, points[a]));
      for (int i = 0; i < 2; ++i)
        scene.state.x(cell.dofs[a * cell.n_components + i]) = value[i];
    }
  scene.state.x.zero_out_ghost_values();
  scene.state.x.update_ghost_values();
}

/// The stretch along X1 that leaves the sides without force when the square is pressed to @p
/// stretch along X3: mu (l - 1/l) + K ln(l stretch) / l = 0.
double free_stretch(const double stretch)
{
  double l = 1. / stretch;
  for (int i = 0; i < 50; ++i) {
    const double force = mu * (l - 1. / l) + 1000. * mu * std::log(l * stretch) / l;
    const double slope =
        mu * (1. + 1. / (l * l)) + 1000. * mu * (1. - std::log(l * stretch)) / (l * l);
    l -= force / slope;
  }
  return l;
}

/// Unstable directions of the square under plane uniaxial pressure, all sides held there.
long long unstable_directions(TestScene<2>& scene, const double stretch)
{
  const double l = free_stretch(stretch);
  displace(scene, [&](const dealii::Point<2>& X) {
    return dealii::Point<2>((l - 1.) * X[0], (stretch - 1.) * X[1]);
  });
  scene.system.relax_internal();
  EXPECT_LT(scene.system.residual().norm, 1e-9);
  scene.system.assemble_tangent();
  Mumps solver(MPI_COMM_WORLD, true);
  return scene.system.unstable_directions(solver.factorise(scene.system.tangent()).negative_pivots);
}

/// The largest stretch below 1 at which the square is unstable, or 0 if there is none above 0.1.
double critical_stretch(const std::string& formulation, const int degree, const int n)
{
  TestScene<2> scene(square(formulation, degree, n, held));
  double stable = 1., unstable = 0.;
  for (double stretch = 1.; stretch > 0.1 && unstable == 0.; stretch -= 0.01)
    if (unstable_directions(scene, stretch) > 0)
      unstable = stretch;
    else
      stable = stretch;
  while (unstable > 0. && stable - unstable > 1e-6) {
    const double middle = (stable + unstable) / 2.;
    (unstable_directions(scene, middle) > 0 ? unstable : stable) = middle;
  }
  return unstable;
}

TEST(ElementFailures, EnhancedStrainHourglassesUnderCompression)
{
  for (const int n : {2, 4, 8})
    std::printf("enhanced strain, %d x %d cells: unstable below stretch %.4f\n", n, n,
                critical_stretch("enhanced strain", 1, n));
  for (const auto& [name, degree] : {std::pair{"mean dilatation", 1},
                                     {"mean dilatation", 2},
                                     {"selective reduced", 1},
                                     {"selective reduced", 2},
                                     {"standard", 1},
                                     {"standard", 2}})
    std::printf("%s, degree %d, 4 x 4 cells: %.4f\n", name, degree,
                critical_stretch(name, degree, 4));
}

/// Eigenvalues of the tangent of a free undeformed cell (2 x 1 of them), smallest first.
std::vector<double> eigenvalues(const std::string& formulation, const int degree)
{
  TestScene<2> scene(square(formulation, degree, 2, "pin: u1 u3, tip: u1"));
  scene.system.residual();
  scene.system.assemble_tangent();
  std::vector<unsigned int> free;
  for (unsigned int i = 0; i < scene.state.x.size(); ++i)
    if (!scene.conditions.constraints().is_constrained(i))
      free.push_back(i);
  const unsigned int n = free.size();
  dealii::LAPACKFullMatrix<double> K(n, n);
  BlockVector e = scene.layout.new_vector(), column = scene.layout.new_vector();
  for (unsigned int j = 0; j < n; ++j) {
    e = 0.;
    e(free[j]) = 1.;
    scene.system.tangent().vmult(column, e);
    for (unsigned int i = 0; i < n; ++i)
      K(i, j) = column(free[i]);
  }
  dealii::FullMatrix<double> vectors;
  dealii::Vector<double> values;
  K.compute_eigenvalues_symmetric(-1e6, 1e6, 1e-14, values, vectors);
  return std::vector<double>(values.begin(), values.end());
}

TEST(ElementFailures, NoneHasModesWithoutEnergy)
{
  for (const auto& [name, degree] : {std::pair{"enhanced strain", 1},
                                     {"mean dilatation", 1},
                                     {"mean dilatation", 2},
                                     {"selective reduced", 1},
                                     {"selective reduced", 2},
                                     {"standard", 1},
                                     {"standard", 2}}) {
    const std::vector<double> values = eigenvalues(name, degree);
    std::printf("%s, degree %d: smallest eigenvalue / mu %.4f\n", name, degree, values[0] / mu);
    EXPECT_GT(values[0], 1e-2 * mu) << name;
  }
}

/// The sides of 2 x 2 cells are held and the middle of one is moved along it by d: the pressures
/// of the four cells, seen through the pattern + - + -, in units of mu d/h.
double checkerboard(const std::string& formulation, const int degree)
{
  constexpr double d = 1e-4;
  TestScene<2> scene(square(formulation, degree, 2, held));
  displace(scene, [&](const dealii::Point<2>& X) {
    const bool moved = std::abs(X[0] - 1.) < 1e-9 && std::abs(X[1] - 2.) < 1e-9;
    return dealii::Point<2>(moved ? d : 0., 0.);
  });
  const NewtonReport report = Newton().solve(scene.system);
  EXPECT_TRUE(report.converged) << report.reason;
  double sum = 0.;
  const unsigned int n = scene.system.element().n_internal();
  for (std::size_t index = 0; index < 4; ++index) {
    const auto centre = scene.layout.cells()[index].iterator->center();
    sum += ((centre[0] < 1.) == (centre[1] < 1.) ? 1. : -1.) * scene.state.internal[index * n] / 4.;
  }
  return std::abs(sum) / (mu * d);
}

TEST(ElementFailures, PressureOfQ1P0IsACheckerboard)
{
  for (const auto& [name, degree] :
       {std::pair{"mean dilatation", 1}, {"enhanced strain", 1}, {"mean dilatation", 2}})
    std::printf("%s, degree %d: checkerboard %.3f mu d/h\n", name, degree,
                checkerboard(name, degree));
}

/// The most unstable displacement (of size 1) and its eigenvalue: Lanczos' method for the inverse
/// of K_uu - K_uphi K_phiphi^-1 K_phiu, which is the u-part of the inverse of the tangent.
std::pair<double, BlockVector> most_unstable_mode(TestScene<3>& scene)
{
  constexpr unsigned int n = 80;
  Mumps solver(MPI_COMM_WORLD, true);
  scene.system.assemble_tangent();
  solver.factorise(scene.system.tangent());
  std::vector<BlockVector> basis;
  dealii::LAPACKFullMatrix<double> H(n, n);
  BlockVector v = scene.layout.new_vector();
  add_noise(scene, {1., 0.}, v);
  for (unsigned int k = 0; k < n; ++k) {
    v /= v.l2_norm();
    basis.push_back(v);
    solver.solve(v);
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
  for (unsigned int k = 0; k < values.size(); ++k)
    std::printf("eigenvalue %.4e\n", 1. / values[k]);
  BlockVector mode = scene.layout.new_vector();
  for (unsigned int i = 0; i < n && values.size() > 0; ++i)
    mode.add(vectors(i, 0), basis[i]);
  mode.update_ghost_values();
  return {values.size() > 0 ? 1. / values[0] : 0., mode};
}

TEST(ElementFailures, SoftestModeOfThePapersMesh)
{
  TestScene<3> scene(
      "subsection Mesh\n set File = meshes/bilayer.geo\n"
      " set Parameters = L: 20, W: 4, H: 1, n1: 4, n2: 8, n3: 20\nend\n"
      "subsection Regions\n set Materials = active: elastomer, passive: elastomer\n"
      " set Passive = passive\nend\nsubsection Materials\n subsection elastomer\n"
      "  set Thermal expansion = 1.8e-4\n end\nend\n"
      "subsection Discretisation\n set Formulation = mean dilatation\nend\n"
      "subsection Supports\n set Fixed = x3_min: u3, x2_min: u2, x2_max: u2, pin: u1\nend\n"
      "subsection Electrodes\n set Potential = interface: 0, outer: 1\nend\n",
      353.);
  const double per_e = 10.5325 / 0.87; // kV
  for (double e = 0.; e < 0.7405; e += 0.02) {
    scene.conditions.apply(e * per_e, 293., 1., scene.state.x);
    const NewtonReport report = Newton().solve(scene.system);
    ASSERT_TRUE(report.converged) << e << report.reason;
  }
  const BlockVector v = most_unstable_mode(scene).second;
  // Shares of the components, and the mode along lines.
  double share[3] = {0., 0., 0.};
  const auto& points = scene.layout.scalar_element().get_unit_support_points();
  std::map<std::tuple<int, int, int>, std::array<double, 3>> nodes;
  for (const Cell<3>& cell : scene.layout.cells())
    for (unsigned int a = 0; a < points.size(); ++a) {
      const auto X = dealii::MappingQ1<3>().transform_unit_to_real_cell(cell.iterator, points[a]);
      std::array<double, 3> value;
      for (int i = 0; i < 3; ++i)
        value[i] = v(cell.dofs[a * cell.n_components + i]);
      nodes[std::make_tuple(int(std::lround(X[0] * 4)), int(std::lround(X[1] * 2)),
                            int(std::lround(X[2])))] = value;
    }
  for (const auto& [where, value] : nodes)
    for (int i = 0; i < 3; ++i)
      share[i] += value[i] * value[i];
  std::printf("shares %.3f %.3f %.3f\n", share[0], share[1], share[2]);
  for (const int x3 : {0, 1, 5, 10, 15, 19, 20}) {
    std::printf("x3 = %d, u1 at outer along x2:", x3);
    for (int x2 = 0; x2 <= 8; ++x2)
      std::printf(" %7.4f", nodes[std::make_tuple(0, x2, x3)][0]);
    std::printf("   u2 at outer:");
    for (int x2 = 0; x2 <= 8; ++x2)
      std::printf(" %7.4f", nodes[std::make_tuple(0, x2, x3)][1]);
    std::printf("   u3:");
    for (int x2 = 0; x2 <= 8; ++x2)
      std::printf(" %7.4f", nodes[std::make_tuple(0, x2, x3)][2]);
    std::printf("   u2 at x2 = 1, 2 along x1:");
    for (int x1 = 0; x1 <= 4; ++x1)
      std::printf(" %7.4f", nodes[std::make_tuple(x1, 2, x3)][1]);
    std::printf("\n");
  }
}

} // namespace
