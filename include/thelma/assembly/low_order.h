#pragma once

#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/state.h>
#include <thelma/solvers/linear_solver.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <array>
#include <vector>

namespace thelma
{

/// Stand-ins for the displacement and potential blocks of a tangent, on the deformed body and with
/// linear elements between the same nodes (theory.md, eq. 48): 2 mu sym(grad v) : sym(grad w) and
/// eps grad(phi) . grad(chi). Positive in every state, with the rigid motions as only null space.
template <int dim>
class LowOrder final : public Surrogates
{
public:
  LowOrder(const FieldLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
           const State& state);

  void update() override;
  const dealii::TrilinosWrappers::SparseMatrix* matrix(unsigned int block) const override;
  const std::vector<std::vector<double>>& rigid_motions() const override { return motions; }
  unsigned int components(const unsigned int block) const override { return block == 0 ? dim : 1; }

private:
  using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
  static constexpr unsigned int n_corners = 1 << dim;
  using Corners = std::array<unsigned int, n_corners>; ///< nodes of a part of a cell
  using Positions = std::array<dealii::Tensor<1, dim>, n_corners>;
  /// Gradients of the corners' functions at a point, and its weight.
  struct Point {
    std::array<dealii::Tensor<1, dim>, n_corners> gradients;
    double weight;
  };

  void find_parts();
  void find_nodes();
  void make_pattern(unsigned int block);
  void find_motions();
  void assemble(const Cell<dim>& cell, const Positions& x, const Corners& part, double mu,
                double eps);
  void add(unsigned int block, const Cell<dim>& cell, const Corners& part,
           const std::vector<double>& entries);
  std::vector<long long> rows(unsigned int block, const Cell<dim>& cell, const Corners& part) const;
  std::array<Point, n_corners> points(const Positions& x) const;
  void fix_diagonal(unsigned int block);

  const FieldLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  const State& state;
  std::vector<Corners> parts;
  std::array<std::array<dealii::Tensor<1, dim>, n_corners>, n_corners> reference_gradients;
  BlockVector nodes; ///< reference position of each displacement unknown along its own axis
  std::vector<SparseMatrix> matrices; ///< of displacement and, where there is one, potential
  std::vector<dealii::types::global_dof_index> starts; ///< of the blocks
  std::vector<std::vector<double>> motions;
};

} // namespace thelma
