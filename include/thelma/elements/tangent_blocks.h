#pragma once

#include <thelma/elements/basis.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <vector>

namespace thelma
{

/// The tangent of one cell while it is summed: a dense block C_ab over the nodes for each pair of
/// components, its rows padded to whole vector registers.
class TangentBlocks
{
public:
  /// Displacement in space, potential and temperature.
  static constexpr unsigned int most_components = 5;

  /// Begin a cell; of a @p symmetric tangent only the blocks c <= d are given.
  void reset(unsigned int n_nodes, unsigned int n_components, bool symmetric);

  /// C_ab += sum_k A_ka B_kb in the block of the components c, d, for padded rows A_k of any place
  /// and a dense B of such rows.
  void add_product(unsigned int c, unsigned int d, unsigned int n_k, const double* const* A,
                   const double* B);

  /// Entry (a, b) of block c, d.
  double& entry(unsigned int c, unsigned int d, unsigned int a, unsigned int b);

  /// Row by row with the unknowns ordered [a][c].
  void write(std::vector<double>& tangent) const;

private:
  double* begin(const unsigned int c, const unsigned int d)
  {
    return values.data() + place(c, d) * block_size();
  }
  std::size_t place(const unsigned int c, const unsigned int d) const
  {
    return std::size_t(c) * n_components + d;
  }
  std::size_t block_size() const { return std::size_t(stride) * stride; }
  void write_row(unsigned int c, unsigned int a, double* row) const;

  unsigned int n_nodes = 0, stride = 0, n_components = 0;
  bool symmetric = true;

  /// Which blocks are there, [c * n_components + d].
  std::array<bool, std::size_t(most_components) * most_components> filled{};
  dealii::AlignedVector<double> values;
};

} // namespace thelma
