#pragma once

#include <thelma/assembly/cell_loop.h>

#include <vector>

namespace thelma
{

/// The unknowns inside the cells in a linear system, from which they are eliminated: their
/// residual, what the newest tangent keeps for them, and the corrections that belong to nodal ones.
template <int dim>
class CondensedUnknowns
{
public:
  CondensedUnknowns(const CellLoop<dim>& cells, const DofLayout<dim>& layout, State& state)
      : cells(cells), layout(layout), state(state)
  {
  }

  /// The state must have its internal unknowns.
  void setup();

  /// Keep what an own cell tells at the iterate, and of its tangent.
  void keep_residual(std::size_t cell, const CellResult& result);
  void keep_tangent(std::size_t cell, const CellResult& result);

  std::vector<double>& residual() { return residuals; }
  Elimination<dim> elimination(std::size_t cell) const;

  /// Add what the elimination of their residual does to the @p nodal one.
  void eliminate(BlockVector& nodal) const;

  /// From now on steps begin at the iterate.
  void begin() { base = state.internal; }

  /// Find the correction, or the response to a load, that belongs to the nodal one, @p dx.
  void correct(BlockVector& dx) { recover(dx, correction); }
  void respond(BlockVector& dx) { recover(dx, response); }

  void add_response(double change);
  void move_to(double step);

  /// Add the correction to the iterate. Whether that made a difference anywhere.
  bool add_correction();

private:
  void recover(BlockVector& dx, std::vector<double>& values) const;

  const CellLoop<dim>& cells;
  const DofLayout<dim>& layout;
  State& state;
  std::vector<double> residuals, eliminations; ///< of all own cells
  std::vector<double> base, correction, response;
};

} // namespace thelma
