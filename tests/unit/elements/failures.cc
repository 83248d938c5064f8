// When each element formulation fails (doc/elements.md), in the smallest case that shows it. The
// truth is the continuum: neo-Hookean rubber of constant volume is elliptic at every stretch.

#include "scene.h"

#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <thelma/solvers/mumps.h>

#include <gtest/gtest.h>

#include <functional>

namespace
{

using namespace thelma_test;

constexpr double mu = 0.056552; // MPa at 293 K

/// A square of 2 x 2 mm in plane strain without a field, in n1 x n3 cells.
std::string square(const std::string& formulation, const int degree, const int n1, const int n3,
                   const std::string& fixed)
{
  return "subsection Mesh\n set File = meshes/bilayer_plane.geo\n"
         " set Parameters = L: 2, H: 2, n1: " +
         std::to_string(n1) + ", n3: " + std::to_string(n3) +
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
  scene.system.converge_internal();
  EXPECT_LT(scene.system.residual().norm, 1e-9);
  scene.system.linear.assemble();
  Mumps solver(MPI_COMM_WORLD, true);
  return scene.system.stability.unstable_directions(
      solver.factorise(scene.system.linear.matrix()).negative_pivots);
}

/// The largest stretch below 1 at which the square is unstable, or 0 if there is none above 0.1.
double critical_stretch(const std::string& formulation, const int degree, const int n1,
                        const int n3)
{
  TestScene<2> scene(square(formulation, degree, n1, n3, held));
  double stable = 1., unstable = 0.;
  for (double stretch = 1.; stretch > 0.1 && unstable == 0.; stretch -= 0.01)
    (unstable_directions(scene, stretch) > 0 ? unstable : stable) = stretch;
  while (unstable > 0. && stable - unstable > 1e-6) {
    const double middle = (stable + unstable) / 2.;
    (unstable_directions(scene, middle) > 0 ? unstable : stable) = middle;
  }
  return unstable;
}

/// The truth: with its boundary held, an elliptic homogeneous body is stable. Enhanced strain is so
/// above the stretches of doc/elements.md.
TEST(ElementFailures, EnhancedStrainHourglassesUnderCompression)
{
  struct Cells {
    int n1, n3;
    double stable_above;
  };
  for (const auto& [n1, n3, stable_above] : {Cells{2, 2, 0.258},
                                             {4, 4, 0.559},
                                             {8, 8, 0.638},
                                             {8, 16, 0.793},
                                             {8, 32, 0.885},
                                             {16, 8, 0.574}}) {
    const double critical = critical_stretch("enhanced strain", 1, n1, n3);
    std::printf("enhanced strain, %d x %d cells: unstable below stretch %.3f\n", n1, n3, critical);
    EXPECT_LT(critical, stable_above + 1e-3) << n1 << " x " << n3;
  }
  for (const auto& [name, degree] : {std::pair{"standard", 1},
                                     {"standard", 2},
                                     {"selective reduced", 1},
                                     {"selective reduced", 2},
                                     {"mean dilatation", 1},
                                     {"mean dilatation", 2}}) {
    std::printf("%s, degree %d: stable\n", name, degree);
    EXPECT_EQ(critical_stretch(name, degree, 4, 16), 0.) << name << degree;
  }
}

/// Smallest eigenvalue of the tangent of 2 x 2 undeformed cells that are only kept from moving as
/// rigid bodies.
double smallest_eigenvalue(const std::string& formulation, const int degree)
{
  TestScene<2> scene(square(formulation, degree, 2, 2, "pin: u1 u3, tip: u1"));
  EXPECT_LT(scene.system.residual().norm, 1e-15) << "not at rest";
  scene.system.linear.assemble();
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
    scene.system.linear.matrix().vmult(column, e);
    for (unsigned int i = 0; i < n; ++i)
      K(i, j) = column(free[i]);
  }
  dealii::FullMatrix<double> vectors;
  dealii::Vector<double> values;
  K.compute_eigenvalues_symmetric(-1e6, 1e6, 1e-14, values, vectors);
  return values[0];
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
    const double smallest = smallest_eigenvalue(name, degree);
    std::printf("%s, degree %d: smallest eigenvalue %.3f mu\n", name, degree, smallest / mu);
    EXPECT_GT(smallest, 1e-2 * mu) << name;
  }
}

/// The sides of 2 x 2 cells are held and the middle of one is moved along it by d: the pressures
/// of the four cells of size h, seen through the pattern + - + -, in units of mu d/h.
double checkerboard(const std::string& formulation, const int degree)
{
  constexpr double d = 1e-4;
  TestScene<2> scene(square(formulation, degree, 2, 2, held));
  displace(scene, [&](const dealii::Point<2>& X) {
    const bool moved = std::abs(X[0] - 1.) < 1e-9 && std::abs(X[1] - 2.) < 1e-9;
    return dealii::Point<2>(moved ? d : 0., 0.);
  });
  const NewtonReport report = Newton().solve(scene.system);
  EXPECT_TRUE(report.converged) << report.reason;
  double sum = 0.;
  const unsigned int n = scene.system.cells.formulation().n_internal();
  for (std::size_t index = 0; index < 4; ++index) {
    const auto centre = scene.layout.cells()[index].iterator->center();
    sum += ((centre[0] < 1.) == (centre[1] < 1.) ? 1. : -1.) * scene.state.internal[index * n] / 4.;
  }
  return std::abs(sum) / (mu * d);
}

/// By hand: no displacement of the node in the middle changes the alternating sum of the four
/// cells' areas, and the one that moves changes it by d h, so the pressure is K d/(4h), however
/// small d.
TEST(ElementFailures, ConstantPressureOfLinearElementsIsACheckerboard)
{
  for (const auto& [name, degree] :
       {std::pair{"mean dilatation", 1}, {"enhanced strain", 1}, {"mean dilatation", 2}}) {
    const double size = checkerboard(name, degree);
    std::printf("%s, degree %d: checkerboard of %.2f mu d/h\n", name, degree, size);
    EXPECT_NEAR(size, degree == 1 ? 250. : 0., 1.) << name;
  }
}

/// Negative eigenvalues of the derivative of a cell's internal residual, by central differences.
int negative_eigenvalues(const Formulation<2>& element, const CellView<2>& view)
{
  const unsigned int n = element.n_internal();
  const double h = 1e-6;
  std::vector<double> internal(view.internal, view.internal + n);
  const CellView<2> varied{view.index,      view.cell,  view.x,
                           internal.data(), view.theta, view.has_temperature};
  dealii::LAPACKFullMatrix<double> H(n, n);
  CellResult plus, minus;
  for (unsigned int j = 0; j < n; ++j) {
    const double value = internal[j];
    internal[j] = value + h;
    element.residual(varied, plus);
    internal[j] = value - h;
    element.residual(varied, minus);
    internal[j] = value;
    for (unsigned int i = 0; i < n; ++i)
      H(i, j) = (plus.internal[i] - minus.internal[i]) / (2. * h);
  }
  dealii::Vector<double> values;
  dealii::FullMatrix<double> vectors;
  H.compute_eigenvalues_symmetric(-1e10, 0., 1e-14, values, vectors);
  return static_cast<int>(values.size());
}

/// What the condensed tangent cannot show is reported beside it: a cell under high pressure is
/// unstable inside if its sides are not parallel. Of the negative eigenvalues of a stable cell, one
/// for each mode belongs to pressure and dilatation and one to the potential.
TEST(ElementFailures, EnhancedStrainCountsInstabilitiesInsideItsCells)
{
  int most = 0;
  for (const double stretch : {1., 0.99, 0.95}) {
    TestScene<2> scene("subsection Mesh\n set File = meshes/bilayer_plane.geo\n"
                       " set Parameters = L: 1, H: 2, n1: 2, n3: 1\n set Imperfection = 0.2\n"
                       " set Imperfection shape = x3*(x1-1)^2; 0; x1*(1-x3)\nend\n"
                       "subsection Regions\n set Materials = active: elastomer, passive: "
                       "elastomer\nend\n"
                       "subsection Discretisation\n set Formulation = enhanced strain\nend\n"
                       "subsection Supports\n set Fixed = pin: u1 u3, tip: u1\nend\n"
                       "subsection Electrodes\n set Potential = interface: 0, outer: 1\nend\n");
    const auto& points = scene.layout.scalar_element().get_unit_support_points();
    for (const Cell<2>& cell : scene.layout.cells())
      for (unsigned int a = 0; a < points.size(); ++a) {
        const dealii::Point<2> X =
            dealii::MappingQ1<2>().transform_unit_to_real_cell(cell.iterator, points[a]);
        for (int i = 0; i < 2; ++i)
          scene.state.x(cell.dofs[a * 3 + i]) = (stretch - 1.) * X[i];
        scene.state.x(cell.dofs[a * 3 + 2]) = 5. * X[0];
      }
    scene.state.x.zero_out_ghost_values();
    scene.state.x.update_ghost_values();
    scene.system.converge_internal();
    const Formulation<2>& element = scene.system.cells.formulation();
    scene.system.cells.for_each([&](const CellView<2>& view) {
      CellResult result;
      element.tangent(view, result);
      std::printf("stretch %g: %d unstable direction(s) inside the cell\n", stretch,
                  result.unstable_inside);
      EXPECT_EQ(result.unstable_inside, negative_eigenvalues(element, view) - 3 - 2);
      most = std::max(most, result.unstable_inside);
    });
  }
  EXPECT_GT(most, 0);
}

} // namespace
