#pragma once

#include <thelma/elements/basis.h>
#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/state.h>
#include <thelma/materials/point.h>
#include <thelma/solvers/laplacian.h>

#include <functional>
#include <memory>
#include <vector>

namespace thelma
{

/// Finds the displacement whose gradient comes nearest to a given one (theory.md, eq. 78).
template <int dim>
class GradientFit
{
public:
  /// Says the gradient at a point where some states have the deformation gradients @p F.
  using Gradient = std::function<Tensor3<2>(const std::vector<Tensor3<2>>& F)>;

  /// The fields and constraints must stand. A body whose tangents are too large to be factorised
  /// @p is_large.
  GradientFit(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
              bool is_large);

  /// Add to the displacement of @p x the one whose gradient comes nearest to what @p wanted
  /// says of the @p states, unless that is negligible.
  void add(const Gradient& wanted, const std::vector<State::Accepted>& states, BlockVector& x);

  /// Where gradients are looked at.
  const Integration<dim>& points() const { return reduced; }

private:
  void make_laplacian();

  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  bool is_large;
  Integration<dim> full, reduced;
  std::unique_ptr<Laplacian> laplacian; ///< of each displacement component; null until needed
  BlockVector moments;
};

} // namespace thelma
