#pragma once

#include <thelma/fields/boundary_conditions.h>
#include <thelma/fields/layout.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <array>
#include <vector>

namespace thelma
{

/// Linear elements between the nodes, or some of them: 2 mu sym(grad v) : sym(grad w) and
/// eps grad(phi) . grad(chi) as matrices of the displacement and potential unknowns.
template <int dim>
class LowOrderGrid
{
public:
  using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
  using Positions = std::vector<dealii::Tensor<1, dim>>;

  /// Of the first @p n_blocks fields, between every @p spacing -th node of a cell along each axis.
  /// Unless that is every node, the unknowns are numbered anew, with those of a node one after
  /// the other.
  LowOrderGrid(const FieldLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
               unsigned int n_blocks, unsigned int spacing);

  /// Begin a new assembly.
  void clear();

  /// Add an own cell with its nodes at @p x, of shear modulus @p mu and permittivity @p eps.
  void add(const Cell<dim>& cell, const Positions& x, double mu, double eps);

  /// End it.
  void finish();

  const SparseMatrix& matrix(const unsigned int block) const { return blocks[block].matrix; }
  const dealii::IndexSet& owned(const unsigned int block) const { return blocks[block].owned; }

  /// Number of an unknown by its place in this rank's part of the block, negative where it is none
  /// of the grid's.
  long long number(const unsigned int block, const unsigned int local) const
  {
    return blocks[block].numbers[local];
  }
  bool is_free(const unsigned int block, const unsigned int local) const
  {
    return blocks[block].free[local];
  }

private:
  static constexpr std::size_t n_corners = 1 << dim;
  using Corners = std::array<unsigned int, n_corners>; ///< nodes of a part of a cell
  /// Gradients of the corners' functions at a point, and its weight.
  struct Point {
    std::array<dealii::Tensor<1, dim>, n_corners> gradients;
    double weight;
  };
  /// The matrix of a field and its unknowns, by their place in this rank's part of the vector.
  struct Block {
    unsigned int first_component, n_components;
    std::vector<long long> numbers;
    std::vector<bool> free;
    dealii::IndexSet owned, relevant;
    std::vector<int> columns; ///< Trilinos' own numbers
    SparseMatrix matrix;
  };

  using Vector = BlockVector::BlockType;
  using Partitioner = dealii::Utilities::MPI::Partitioner;

  void find_parts(unsigned int spacing);
  void number_all(Block& block, const Partitioner& places,
                  const BoundaryConditions<dim>& conditions);
  void number_some(Block& block, Vector numbers);
  void make_pattern(Block& block);
  std::vector<unsigned int> unknowns(const Block& block, const Cell<dim>& cell,
                                     const Corners& part) const;
  std::array<Point, n_corners> points(const Corners& part, const Positions& x) const;
  void add(Block& block, const std::vector<unsigned int>& unknowns, const double* entries);
  void add_row(Block& block, const std::vector<unsigned int>& unknowns, std::size_t i,
               const double* entries);
  void fix_diagonal(Block& block);

  const FieldLayout<dim>& layout;
  std::vector<Corners> parts;
  std::array<std::array<dealii::Tensor<1, dim>, n_corners>, n_corners> reference_gradients;
  std::vector<Block> blocks; ///< of displacement and potential
};

} // namespace thelma
