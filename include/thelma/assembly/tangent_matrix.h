#pragma once

#include <thelma/assembly/cell_places.h>
#include <thelma/fields/boundary_conditions.h>
#include <thelma/loads/load.h>

#include <deal.II/lac/trilinos_block_sparse_matrix.h>

#include <functional>
#include <vector>

namespace thelma
{

/// The tangent as a block matrix, with the place of every cell entry in it found once.
///
/// Prescribed unknowns keep a row with 1 on the diagonal. Rows of other ranks (few, along the
/// partition's border) go the ordinary way through Trilinos.
template <int dim>
class TangentMatrix final : public TangentEntries<dim>
{
public:
  /// Which pairs of a cell's components have entries; a component without any keeps 1 on the
  /// diagonal.
  using Coupling = std::function<bool(const Cell<dim>&, unsigned int, unsigned int)>;

  void setup(
      const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
      Coupling coupling = [](const Cell<dim>&, unsigned int, unsigned int) { return true; });

  /// Begin a new assembly.
  void clear();

  void add(std::size_t index, const Cell<dim>& cell, const std::vector<double>& entries) override;
  void add_diagonal(dealii::types::global_dof_index unknown, double value) override;

  /// End the assembly: exchange the rows of other ranks.
  void finish();

  const dealii::TrilinosWrappers::BlockSparseMatrix& matrix() const { return tangent; }

private:
  void make_pattern(const DofLayout<dim>& layout);
  void find_places(const DofLayout<dim>& layout);
  double* entry(dealii::types::global_dof_index row, dealii::types::global_dof_index column);
  template <typename Visitor>
  void for_each_run(const CellPlaces& place, std::size_t i, const Visitor& visit) const;
  void add_row(const Cell<dim>& cell, std::size_t i, const CellPlaces& place,
               const double* entries);
  std::vector<bool> free_unknowns(const Cell<dim>& cell) const;
  std::vector<unsigned int> columns(const Cell<dim>& cell, std::size_t i,
                                    const std::vector<bool>& is_free) const;

  const dealii::AffineConstraints<double>* constraints = nullptr;
  Coupling coupling;
  dealii::TrilinosWrappers::BlockSparseMatrix tangent;
  std::vector<double*> block_values;    ///< of the local part of block (i, j)
  std::vector<double*> fixed_diagonals; ///< of this rank's unknowns without equation
  std::vector<CellPlaces> places;       ///< of every own cell
};

} // namespace thelma
