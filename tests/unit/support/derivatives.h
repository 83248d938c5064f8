#pragma once

#include "scene.h"

#include <thelma/solvers/mumps.h>

#include <deal.II/fe/mapping_q1.h>

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
  Mumps solver(MPI_COMM_WORLD, scene.system.linear.is_symmetric());
  const auto error_after_a_step_from = [&](const double d) {
    scene.state.x = solution;
    scene.state.x.add(d, direction);
    scene.state.x.update_ghost_values();
    scene.system.converge_internal();
    EXPECT_TRUE(scene.system.residual().admissible());
    scene.system.linear.assemble();
    EXPECT_TRUE(solver.factorise(scene.system.linear.matrix()).solved);
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

/// A bent, charged and heated state: the layers curl about x2 and carry random fields.
template <int dim>
void set_bent_state(TestScene<dim>& scene, const double curvature)
{
  const auto& points = scene.layout.scalar_element().get_unit_support_points();
  for (const Cell<dim>& cell : scene.layout.cells())
    for (unsigned int a = 0; a < points.size(); ++a) {
      const dealii::Point<dim> X =
          dealii::MappingQ1<dim>().transform_unit_to_real_cell(cell.iterator, points[a]);
      const double angle = curvature * X[dim - 1], radius = 1. / curvature - X[0];
      scene.state.x(cell.dofs[a * cell.n_components]) =
          1. / curvature - radius * std::cos(angle) - X[0];
      scene.state.x(cell.dofs[a * cell.n_components + dim - 1]) =
          radius * std::sin(angle) - X[dim - 1];
      if (cell.has_potential)
        scene.state.x(cell.dofs[a * cell.n_components + dim]) = 8. * (1. - 2. * X[0]);
    }
  scene.state.x.zero_out_ghost_values();
  scene.state.x.update_ghost_values();
}

/// The assembled tangent is the derivative of the residual, with the internal unknowns eliminated.
template <int dim>
void expect_tangent_is_derivative(TestScene<dim>& scene)
{
  ASSERT_TRUE(scene.system.residual().admissible());
  scene.system.linear.assemble();
  const BlockVector x = scene.state.x;

  // One direction per field, so that every block of the tangent is seen by itself.
  const std::vector<double> size{1e-4, 1e-2, 1e-1};
  for (unsigned int b = 0; b < x.n_blocks(); ++b) {
    std::vector<double> amplitude(3, 0.);
    amplitude[b] = size[b];
    BlockVector direction = scene.layout.new_vector();
    add_noise(scene, amplitude, direction);
    BlockVector product = scene.layout.new_vector();
    scene.system.linear.matrix().vmult(product, direction);

    BlockVector slope = scene.layout.new_vector();
    differentiate(
        scene, direction,
        [&]() {
          scene.system.converge_internal();
          EXPECT_TRUE(scene.system.residual().admissible());
          return scene.system.free_residual();
        },
        [&](const double weight, const BlockVector& residual) { slope.add(weight, residual); });
    for (unsigned int row = 0; row < x.n_blocks(); ++row) {
      auto difference = product.block(row);
      difference -= slope.block(row);
      const double reference = slope.block(row).l2_norm();
      if (reference > 0.)
        EXPECT_LT(difference.l2_norm() / reference, 1e-6) << "block " << row << ", " << b;
      else
        EXPECT_EQ(product.block(row).l2_norm(), 0.) << "block " << row << ", " << b;
    }
  }
}

/// The residual is the slope of elastic minus electric energy.
template <int dim>
void expect_residual_is_slope_of_energy(TestScene<dim>& scene)
{
  const BlockVector x = scene.state.x;
  BlockVector direction = scene.layout.new_vector();
  add_noise(scene, {1e-2, 1e-1, 0.}, direction);

  const double h = 1e-2;
  double slope = 0.;
  for (const auto& [step, weight] :
       {std::pair{h, 8. / 12.}, {-h, -8. / 12.}, {2 * h, -1. / 12.}, {-2 * h, 1. / 12.}}) {
    scene.state.x = x;
    scene.state.x.add(step, direction);
    scene.state.x.update_ghost_values();
    scene.system.converge_internal();
    const Energies energies = scene.system.cells.energies();
    slope += weight / h * (energies.elastic - energies.electric);
  }
  slope = dealii::Utilities::MPI::sum(slope, MPI_COMM_WORLD);
  scene.state.x = x;
  scene.state.x.update_ghost_values();
  scene.system.converge_internal();
  scene.system.residual();
  const double power = scene.system.free_residual() * direction;
  std::cout << "slope of the energy " << slope << ", residual times direction " << power << "\n";
  EXPECT_NEAR(slope, power, 1e-6 * std::abs(power));
}

} // namespace thelma_test
