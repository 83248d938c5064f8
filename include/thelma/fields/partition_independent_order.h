#pragma once

#include <thelma/fields/dof_layout.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace thelma
{

/// The values of all ranks in an order that depends on the mesh alone: unknowns as the cells come
/// to them one after the other, and what lies inside the cells cell by cell. So what some ranks
/// have written any number of others can read.
template <int dim>
class PartitionIndependentOrder
{
public:
  explicit PartitionIndependentOrder(const DofLayout<dim>& layout);

  /// On rank 0 all values of @p x, elsewhere none.
  std::vector<double> collect(const BlockVector& x) const;

  /// The same of values inside the own cells, equally many in each.
  std::vector<double> collect(const std::vector<double>& internal) const;

  /// Take the own ones of all values, which every rank has. Whether there are as many as needed.
  bool distribute(const std::vector<double>& all, BlockVector& x) const;
  bool distribute(const std::vector<double>& all, std::vector<double>& internal) const;

private:
  /// Places in the order, of as many things.
  struct Places {
    std::vector<std::uint64_t> own, all; ///< all: on rank 0, rank after rank
    std::uint64_t total = 0;
  };

  using Key = std::pair<unsigned int, unsigned int>; ///< increases along the order

  Places places(const std::vector<Key>& own) const;
  std::vector<double> sorted(const Places& places, const std::vector<double>& own) const;

  const DofLayout<dim>& layout;
  std::vector<dealii::types::global_dof_index> indices; ///< own ones
  Places unknowns, cells;
};

} // namespace thelma
