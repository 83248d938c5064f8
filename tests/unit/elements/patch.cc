// The patch test: where a distorted mesh is displaced and charged on its whole boundary as by one F
// and one E, every element must find that state inside. The state is the truth.

#include "scene.h"

#include <thelma/base/axes.h>

#include <deal.II/fe/mapping_q1.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace thelma_test;

struct Element {
  const char* formulation;
  int degree;
};

class Patch : public testing::TestWithParam<Element>
{
};

const dealii::Tensor<1, 3> field({3., -2., 8.}); // kV/mm

void PrintTo(const Element& element, std::ostream* out)
{
  *out << element.formulation << ", degree " << element.degree;
}

std::string scene_text(const Element& element, const std::string& mesh,
                       const std::string& materials, const std::string& fixed,
                       const std::string& grounded)
{
  return "subsection Mesh\n " + mesh + "\nend\nsubsection Regions\n set Materials = " + materials +
         "\nend\nsubsection Discretisation\n set Degree = " + std::to_string(element.degree) +
         "\n set Formulation = " + element.formulation +
         "\nend\nsubsection Supports\n set Fixed = " + fixed +
         "\nend\nsubsection Electrodes\n set Potential = " + grounded + "\nend\n";
}

/// With a determinant of 1, or rubber would be under huge pressure.
template <int dim>
dealii::Tensor<2, dim> stretched()
{
  const dealii::Tensor<2, 3> all({{1.20, 0.10, 0.05}, {-0.04, 0.85, 0.06}, {0.02, -0.08, 1.01}});
  dealii::Tensor<2, dim> F;
  for (int i = 0; i < dim; ++i)
    for (int J = 0; J < dim; ++J)
      F[i][J] = all[axis<dim>(i)][axis<dim>(J)];
  return F / std::pow(dealii::determinant(F), 1. / dim);
}

/// How far the solution lies from the state of one F and one E (kV/mm), relative to it.
template <int dim>
double error(TestScene<dim>& scene, const dealii::Tensor<2, dim>& F, const dealii::Tensor<1, 3>& E)
{
  const auto& points = scene.layout.scalar_element().get_unit_support_points();
  for (const Cell<dim>& cell : scene.layout.cells())
    for (unsigned int a = 0; a < points.size(); ++a) {
      const dealii::Point<dim> X =
          dealii::MappingQ1<dim>().transform_unit_to_real_cell(cell.iterator, points[a]);
      dealii::Tensor<1, dim + 1> values;
      for (int J = 0; J < dim; ++J) {
        for (int i = 0; i < dim; ++i)
          values[i] += (F[i][J] - (i == J ? 1. : 0.)) * X[J];
        values[dim] -= E[axis<dim>(J)] * X[J];
      }
      for (int c = 0; c <= dim; ++c)
        scene.state.x(cell.dofs[a * (dim + 1) + c]) = values[c];
    }
  scene.state.x.zero_out_ghost_values();
  const BlockVector exact = scene.state.x;
  BlockVector noise = scene.layout.new_vector();
  add_noise(scene, {2e-3, 0.1}, noise);
  scene.state.x += noise;
  scene.state.x.update_ghost_values();
  const NewtonReport report = Newton().solve(scene.system);
  EXPECT_TRUE(report.converged) << report.reason;
  EXPECT_EQ(scene.system.stability.unstable_directions(report.negative_pivots), 0);
  const double size = exact.l2_norm();
  BlockVector difference = scene.state.x;
  difference.zero_out_ghost_values();
  difference -= exact;
  return difference.l2_norm() / size;
}

TEST_P(Patch, HomogeneousStateInThePlane)
{
  TestScene<2> scene(
      scene_text(GetParam(),
                 "set File = meshes/bilayer_plane.geo\n set Parameters = L: 1, H: 1, n1: 4, n3: 3\n"
                 " set Imperfection = 0.08\n set Imperfection shape = sin(5*x3+1)*sin(3.14159*x1); "
                 "0; cos(4*x1)",
                 "active: elastomer, passive: elastomer",
                 "outer: u1 u3, back: u1 u3, x3_min: u1 u3, x3_max: u1 u3",
                 "outer: 0, back: 0, x3_min: 0, x3_max: 0"));
  const double e = error(scene, stretched<2>(), field);
  std::printf("%s, degree %d: %.1e\n", GetParam().formulation, GetParam().degree, e);
  EXPECT_LT(e, 1e-9);
}

/// With the axis on one side: around it there is one stress only where F is diagonal with F_11 =
/// F_22 and the field runs along it. Reduced rules do not integrate R N_a,J + N_a on distorted
/// cells.
TEST_P(Patch, HomogeneousStateAroundAnAxis)
{
  const bool is_reduced = std::string(GetParam().formulation) == "selective reduced";
  TestScene<2> scene(
      "set Geometry = axisymmetric\n" +
      scene_text(
          GetParam(),
          "set File = meshes/bilayer_plane.geo\n set Parameters = L: 1, H: 1, n1: 4, n3: 3\n" +
              std::string(is_reduced ? "" : " set Imperfection = 0.08\n") +
              " set Imperfection shape = sin(5*x3+1)*sin(3.14159*x1); 0; cos(4*x1)",
          "active: elastomer, passive: elastomer",
          "outer: u1 u3, back: u1 u3, x3_min: u1 u3, x3_max: u1 u3",
          "back: 0, x3_min: 0, x3_max: 0"));
  const dealii::Tensor<2, 2> F({{1.2, 0.}, {0., 1. / 1.44}});
  const double e = error(scene, F, dealii::Tensor<1, 3>({0., 0., 8.}));
  std::printf("%s, degree %d: %.1e\n", GetParam().formulation, GetParam().degree, e);
  EXPECT_LT(e, 1e-9);
}

TEST_P(Patch, HomogeneousStateInSpace)
{
  std::string fixed, grounded;
  for (const std::string side : {"x1_min", "x1_max", "x2_min", "x2_max", "bottom", "top"}) {
    fixed += (fixed.empty() ? "" : ", ") + side + ": u1 u2 u3";
    grounded += (grounded.empty() ? "" : ", ") + side + ": 0";
  }
  TestScene<3> scene(scene_text(
      GetParam(),
      "set File = meshes/box.geo\n set Parameters = L1: 1, L2: 1, L3: 1, n1: 2, n2: 3, n3: 2\n"
      " set Imperfection = 0.08\n"
      " set Imperfection shape = sin(5*x3+x2); cos(4*x1+x3); sin(3*x2-2*x1)",
      "film: elastomer", fixed, grounded));
  const double e = error(scene, stretched<3>(), field);
  std::printf("%s, degree %d: %.1e\n", GetParam().formulation, GetParam().degree, e);
  EXPECT_LT(e, 1e-9);
}

/// No element may take a state that its law has no stress for as solved.
TEST_P(Patch, GentsLimitIsNotPassed)
{
  TestScene<3> scene(scene_text(GetParam(), "set File = meshes/box.geo", "film: elastomer",
                                "bottom: u1 u2 u3", "bottom: 0") +
                     "subsection Materials\n subsection elastomer\n set Elastic law = Gent\n"
                     " set Gent limit = 0.3\n end\nend\n");
  const auto& points = scene.layout.scalar_element().get_unit_support_points();
  const auto stretch_by = [&](const double lambda) {
    const dealii::Tensor<1, 3> stretches({1. / std::sqrt(lambda), 1. / std::sqrt(lambda), lambda});
    for (const Cell<3>& cell : scene.layout.cells())
      for (std::size_t a = 0; a < points.size(); ++a)
        for (int i = 0; i < 3; ++i)
          scene.state.x(cell.dofs[a * cell.n_components + i]) =
              (stretches[i] - 1.) *
              dealii::MappingQ1<3>().transform_unit_to_real_cell(cell.iterator, points[a])[i];
    scene.state.x.zero_out_ghost_values();
    scene.state.x.update_ghost_values();
  };
  stretch_by(1.2); // I_1 - 3 = 0.11
  EXPECT_TRUE(scene.system.residual().admissible());
  stretch_by(1.5); // 0.58
  const ResidualReport report = scene.system.residual();
  EXPECT_GT(report.min_det_F, 0.);
  EXPECT_FALSE(report.admissible());
}

INSTANTIATE_TEST_SUITE_P(
    Formulations, Patch,
    testing::Values(Element{"standard", 1}, Element{"standard", 2}, Element{"selective reduced", 1},
                    Element{"selective reduced", 2}, Element{"mean dilatation", 1},
                    Element{"mean dilatation", 2}, Element{"enhanced strain", 1}),
    [](const auto& info) {
      std::string name = info.param.formulation;
      name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
      return name + std::to_string(info.param.degree);
    });

} // namespace
