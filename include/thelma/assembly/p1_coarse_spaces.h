#pragma once

#include <thelma/assembly/p1_coarse_space.h>
#include <thelma/fields/state.h>
#include <thelma/solvers/linear_solver.h>

#include <array>
#include <vector>

namespace thelma
{

/// Linear elements between the corners of cells of the deformed body, where multigrid goes on from
/// the displacement and potential blocks of a tangent: 2 mu sym(grad v) : sym(grad w) and
/// eps grad(phi) . grad(chi) (theory.md, eq. 81). Positive in every state, with the rigid motions
/// as only null space; in a body of revolution those that strain the circles are nearly in it.
template <int dim>
class P1CoarseSpaces final : public CoarseGrids
{
public:
  P1CoarseSpaces(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
                 const State& state);

  void update() override;
  CoarseGrid of_block(unsigned int block) const override;
  const std::vector<std::vector<double>>& rigid_motions() const override { return motions; }
  unsigned int components(const unsigned int block) const override { return block == 0 ? dim : 1; }

private:
  static constexpr std::size_t n_corners = P1CoarseSpace<dim>::n_corners;
  using Positions = std::array<dealii::Tensor<1, dim>, n_corners>;
  /// Gradients of the corners' functions at a point, how they stretch the circle around an axis,
  /// and its weight.
  struct Point {
    std::array<dealii::Tensor<1, dim>, n_corners> gradients;
    std::array<double, n_corners> around;
    double weight;
  };

  void find_corners();
  void add(const Cell<dim>& cell, const Positions& x, double mu, double eps);
  std::array<Point, n_corners> points(const Positions& x) const;
  void find_motions();

  const DofLayout<dim>& layout;
  const State& state;
  std::vector<P1CoarseSpace<dim>> grids; ///< of displacement and, where there is one, potential
  BlockVector corners; ///< reference position of a corner's displacements along their own axes
  std::array<std::array<double, n_corners>, n_corners> reference_values;
  std::array<std::array<dealii::Tensor<1, dim>, n_corners>, n_corners> reference_gradients;
  std::vector<std::vector<double>> motions;
};

} // namespace thelma
