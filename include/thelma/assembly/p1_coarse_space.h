#pragma once

#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/dof_layout.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace thelma
{

/// A field's unknowns at the corners of cells alone, those of a corner one after the other: a
/// matrix of them, and their linear interpolation to all nodes.
template <int dim>
class P1CoarseSpace
{
public:
  using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
  static constexpr std::size_t n_corners = 1 << dim; ///< of a cell, its first nodes

  /// Of displacement (@p block 0) or potential.
  P1CoarseSpace(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
                unsigned int block);

  /// Begin a new assembly.
  void clear() { values = 0.; }

  /// Add the @p entries of an own cell, row by row, its unknowns ordered [corner][component]. Those
  /// of cells without the field are left out.
  void add(const Cell<dim>& cell, const double* entries);

  /// End it: rows without equation get a diagonal like that of the others.
  void finish();

  const SparseMatrix& matrix() const { return values; }
  const SparseMatrix& prolongation() const { return interpolation; }

  /// Whether the field's unknown with this place in a vector of its block is one of a corner.
  bool is_corner(const unsigned int local) const { return numbers[local] >= 0; }
  bool is_free(const unsigned int local) const { return free[local]; }

private:
  using Vector = BlockVector::BlockType;

  bool has_field(const Cell<dim>& cell) const { return block == 0 || cell.has_potential; }
  /// That of a node, by its place in the vector.
  unsigned int unknown(const Cell<dim>& cell, std::size_t node, unsigned int component) const
  {
    return cell.local[node * cell.n_components + block * dim + component];
  }
  std::vector<unsigned int> unknowns(const Cell<dim>& cell) const;
  void number_corners(Vector new_numbers);
  void make_matrix();
  void make_prolongation(const Vector& vector);
  void add_row(const std::vector<unsigned int>& unknowns, std::size_t i, const double* entries);

  const DofLayout<dim>& layout;
  unsigned int block, components;
  std::vector<long long> numbers; ///< by the place in this rank's part of the vector
  std::vector<bool> free;         ///< likewise
  dealii::IndexSet owned, relevant;
  std::vector<int> columns; ///< Trilinos' own numbers
  SparseMatrix values, interpolation;
};

} // namespace thelma
