#pragma once

#include "scene.h"

#include <thelma/solvers/mumps.h>

#include <gtest/gtest.h>

#include <cmath>

namespace thelma_test
{

/// Fourth-order central difference of @p quantity() along @p direction.
template <int dim, typename Quantity, typename Add>
void differentiate(TestScene<dim>& scene, const BlockVector& direction, const Quantity& quantity,
                   const Add& add)
{
  const BlockVector x = scene.state.x;
  const double h = 1e-2;
  for (const auto& [step, weight] :
       {std::pair{h, 8. / 12.}, {-h, -8. / 12.}, {2 * h, -1. / 12.}, {-2 * h, 1. / 12.}}) {
    scene.state.x = x;
    scene.state.x.add(step, direction);
    scene.state.x.update_ghost_values();
    add(weight / h, quantity());
  }
  scene.state.x = x;
  scene.state.x.update_ghost_values();
}

/// The present state is the exact solution, held by the dead nodal forces it needs: the error after
/// one step of Newton's method from @p distance along @p direction falls as its square.
template <int dim>
void expect_second_order(TestScene<dim>& scene, const BlockVector& direction, const double distance)
{
  const BlockVector solution = scene.state.x, forces = scene.system.free_residual();
  Mumps solver(MPI_COMM_WORLD, scene.system.is_symmetric());
  const auto error_after_a_step_from = [&](const double d) {
    scene.state.x = solution;
    scene.state.x.add(d, direction);
    scene.state.x.update_ghost_values();
    scene.system.relax_internal();
    EXPECT_TRUE(scene.system.residual().admissible());
    scene.system.assemble_tangent();
    EXPECT_TRUE(solver.factorise(scene.system.tangent()).solved);
    BlockVector correction = forces;
    correction -= scene.system.free_residual();
    EXPECT_TRUE(solver.solve(correction).solved);
    correction.add(d, direction);
    return correction.l2_norm();
  };
  const double far = error_after_a_step_from(distance),
               near = error_after_a_step_from(distance / 2.);
  EXPECT_GE(std::log2(far / near), 1.8) << far << " " << near;
}

} // namespace thelma_test
