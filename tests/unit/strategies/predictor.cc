// The prediction of a body that rolls up against the exact circle.

#include "scene.h"

#include <thelma/strategies/predictor.h>

#include <deal.II/fe/mapping_q1.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace thelma_test;

/// The bilayer as an arc of curvature 0.25 load^2 about x2: what voltage does to it.
void roll_up(TestScene<3>& scene, const double load)
{
  const double curvature = 0.25 * load * load;
  const auto& points = scene.layout.scalar_element().get_unit_support_points();
  for (const Cell<3>& cell : scene.layout.cells())
    for (std::size_t a = 0; a < points.size(); ++a) {
      const dealii::Point<3> X =
          dealii::MappingQ1<3>().transform_unit_to_real_cell(cell.iterator, points[a]);
      const double angle = curvature * X[2], x = X[0] - 0.5;
      // Written without 1 / curvature, which does not exist at load 0.
      const double sine = curvature == 0. ? X[2] : std::sin(angle) / curvature;
      const double cosine = curvature == 0. ? 0. : (1. - std::cos(angle)) / curvature;
      scene.state.x(cell.dofs[a * cell.n_components]) = x * std::cos(angle) + cosine - x;
      scene.state.x(cell.dofs[a * cell.n_components + 2]) = sine - x * std::sin(angle) - X[2];
    }
  scene.state.x.zero_out_ghost_values();
  scene.state.x.update_ghost_values();
}

/// Rotations that grow with the square of the voltage are followed; polynomials of the displacement
/// are 60 times worse here.
void follow_rolling(const bool is_large)
{
  TestScene<3> scene(bilayer("uniform", "mean dilatation", 2));
  Predictor<3> predictor(scene.layout, scene.conditions, scene.state);
  predictor.setup(scene.system.element(), is_large);
  for (const double load : {0.5, 0.7, 0.9}) {
    roll_up(scene, load);
    scene.state.accept(load);
  }
  predictor.predict(1.2, LoadSymmetry::voltage);
  auto error = scene.state.x.block(0);
  roll_up(scene, 1.2);
  error -= scene.state.x.block(0);
  EXPECT_LT(error.l2_norm() / scene.state.x.block(0).l2_norm(), 5e-3);
  EXPECT_LT(predictor.prediction_error(), 1e-2);
}

TEST(Predictor, FollowsABodyThatRollsUp)
{
  follow_rolling(false);
  follow_rolling(true);
}

} // namespace
