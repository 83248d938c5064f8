// The block solver keeps the pressures as unknowns; what it finds is what the factorised condensed
// tangent gives.

#include "marks.h"
#include "scene.h"

#include <thelma/solvers/mumps.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace thelma;
using namespace thelma_test;

std::string with_solver(const std::string& scene, const std::string& solver)
{
  return scene + "subsection Linear solver\n set Solver = " + solver +
         "\n set Tolerance = 1e-10\nend\n";
}

/// The correction that raises the voltage of a bent body in equilibrium.
template <int dim>
BlockVector correction(const std::string& text)
{
  TestScene<dim> scene(text);
  for (const double voltage : {1., 3.}) {
    scene.apply_voltage(voltage);
    const NewtonReport found = Newton().solve(scene.system);
    EXPECT_TRUE(found.converged) << found.reason;
  }
  scene.apply_voltage(4.);
  scene.system.residual();
  BlockVector before = scene.state.x;
  const LinearReport report = scene.system.linear_solve(false);
  EXPECT_TRUE(report.solved) << report.reason;
  scene.system.move_to(1.);
  BlockVector change = scene.state.x;
  change -= before;
  change.zero_out_ghost_values();
  return change;
}

void expect_equal_corrections(const std::string& scene)
{
  const BlockVector direct = correction<3>(with_solver(scene, "direct")),
                    block = correction<3>(with_solver(scene, "block"));
  for (unsigned int b = 0; b < direct.n_blocks(); ++b) {
    auto difference = block.block(b);
    difference -= direct.block(b);
    EXPECT_LT(difference.l2_norm(), 1e-7 * direct.block(b).l2_norm()) << "block " << b;
  }
}

ON_TWO_RANKS(BlockSolver);

TEST(BlockSolver, CorrectsLikeTheDirectSolver)
{
  expect_equal_corrections(bilayer("uniform", "mean dilatation", 1));
  expect_equal_corrections(bilayer("uniform", "mean dilatation", 2));
  expect_equal_corrections(bilayer("uniform", "selective reduced", 1));
}

TEST(BlockSolver, CorrectsTemperaturesAmongTheUnknowns)
{
  expect_equal_corrections(bilayer("steady", "mean dilatation", 2));
}

TEST(BlockSolver, SaysThatItDidNotConverge)
{
  TestScene<3> scene(bilayer("uniform", "mean dilatation", 2) +
                     "subsection Linear solver\n set Solver = block\n set Iterations = 3\nend\n");
  scene.apply_voltage(2.);
  scene.system.residual();
  const LinearReport report = scene.system.linear_solve(false);
  EXPECT_FALSE(report.solved);
  EXPECT_NE(report.reason.find("3 iterations"), std::string::npos) << report.reason;
  EXPECT_FALSE(scene.system.stability.is_known());
}

LinearProblem body(const unsigned int dimension, const unsigned long long unknowns)
{
  LinearProblem problem;
  problem.dimension = dimension;
  problem.unknowns = unknowns;
  problem.pressures_can_be_kept = true;
  return problem;
}

TEST(LinearChoice, GoesBySizeDimensionAndWhatTheRunNeeds)
{
  const LinearSettings automatic;
  EXPECT_EQ(choose_linear_solver(automatic, body(3, 1000000)).solver, "block");
  EXPECT_EQ(choose_linear_solver(automatic, body(3, 10000)).solver, "direct");
  EXPECT_EQ(choose_linear_solver(automatic, body(2, 1000000)).solver, "direct");
  LinearProblem flat = body(3, 1000000);
  flat.flatness = 20.;
  EXPECT_EQ(choose_linear_solver(automatic, flat).solver, "direct");
  LinearProblem condensed = body(3, 1000000);
  condensed.pressures_can_be_kept = false;
  EXPECT_EQ(choose_linear_solver(automatic, condensed).solver, "direct");
  LinearProblem counted = body(3, 1000000);
  counted.counts_for = "Stepping/Continuation = automatic";
  EXPECT_EQ(choose_linear_solver(automatic, counted).solver, "direct");
  LinearSettings block;
  block.solver = "block";
  EXPECT_EQ(choose_linear_solver(block, body(3, 10)).solver, "block");
  EXPECT_THROW(choose_linear_solver(block, condensed), InputError);
  EXPECT_THROW(choose_linear_solver(block, counted), InputError);
}

} // namespace
