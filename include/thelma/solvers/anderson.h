#pragma once

#include <deal.II/lac/la_parallel_block_vector.h>

#include <deque>
#include <vector>

namespace thelma
{

/// Iterates or corrections: values at the nodes, and inside the cells of this rank.
struct Unknowns {
  dealii::LinearAlgebra::distributed::BlockVector<double> nodal;
  std::vector<double> internal;

  void add(double factor, const Unknowns& other);
};

/// Anderson's acceleration of iterations x <- x + d(x) with corrections d from an old tangent.
/// From the way in which d has changed with x it takes the combination of past steps that would
/// leave the smallest correction; for linear systems that is GMRES with the old tangent as its
/// preconditioner (Walker and Ni, SIAM J. Numer. Anal. 49, 1715, 2011).
class Anderson
{
public:
  /// @p weights: squared units of the correction's blocks; the internal unknowns follow.
  explicit Anderson(std::vector<double> weights = {}) : weights(std::move(weights)) {}

  /// The tangent is a new one.
  void forget()
  {
    differences.clear();
    last.clear();
  }

  /// Replace the correction @p d at the iterate @p x.
  void accelerate(const Unknowns& x, Unknowns& d);

private:
  double product(const Unknowns& a, const Unknowns& b) const;

  struct Pair {
    Unknowns x, d;
  };
  static constexpr std::size_t memory = 8;

  std::vector<double> weights;
  std::vector<Pair> last;       ///< the newest iterate and its plain correction, if any
  std::deque<Pair> differences; ///< between successive ones
};

} // namespace thelma
