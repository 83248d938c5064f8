#pragma once

#include <thelma/assembly/cell_loop.h>

#include <vector>

namespace thelma
{

/// The stabilisation of the cells, which a strong field makes them need (theory.md, eqs. 28 to 30):
/// that of one state while a solution is sought, so that the equations have a potential, then made
/// to follow the solution.
template <int dim>
class CellStabilisation
{
public:
  CellStabilisation(CellLoop<dim>& cells, const DofLayout<dim>& layout)
      : cells(cells), layout(layout)
  {
  }

  /// Take what the iterate needs.
  void begin();

  /// Bring it nearer to what the iterate needs now. Whether anything has changed.
  bool follow();

private:
  std::vector<double> needed() const;

  CellLoop<dim>& cells;
  const DofLayout<dim>& layout;
  std::vector<double> lacking; ///< when it last followed
  double relaxation = 1.;      ///< part of that which was added
};

} // namespace thelma
