#pragma once

#include <thelma/assembly/low_order_grid.h>
#include <thelma/fields/state.h>
#include <thelma/solvers/linear_solver.h>

#include <memory>
#include <vector>

namespace thelma
{

/// What stands for the displacement block of a tangent, on the deformed body and with linear
/// elements between the same nodes (theory.md, eq. 48). Positive in every state, with the rigid
/// motions as only null space. Where cells have more nodes than their corners, linear elements
/// between these are the next coarser grid of displacements and potential.
template <int dim>
class LowOrder final : public Surrogates
{
public:
  LowOrder(const FieldLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
           const State& state);

  void update() override;
  Surrogate surrogate(unsigned int block) const override;
  const std::vector<std::vector<double>>& rigid_motions() const override { return motions; }
  unsigned int components(const unsigned int block) const override { return block == 0 ? dim : 1; }

private:
  using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;

  void find_nodes();
  void make_prolongation(unsigned int block);
  void find_motions();

  const FieldLayout<dim>& layout;
  const State& state;
  BlockVector nodes; ///< reference position of each displacement unknown along its own axis
  LowOrderGrid<dim> fine;
  std::unique_ptr<LowOrderGrid<dim>> corners;
  std::vector<SparseMatrix> prolongations; ///< from the corners to all nodes
  std::vector<std::vector<double>> motions;
};

} // namespace thelma
