#include <thelma/fields/mesh_order.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <map>
#include <numeric>

namespace thelma
{
namespace
{

/// On rank 0 what all ranks have, rank after rank; elsewhere nothing.
template <typename Value>
std::vector<Value> joined(const MPI_Comm comm, const std::vector<Value>& own)
{
  std::vector<Value> all;
  for (const std::vector<Value>& part : dealii::Utilities::MPI::gather(comm, own))
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// What rank 0 has for all ranks, rank after rank: this rank's @p n_own of them.
std::vector<std::uint64_t> dealt_out(const MPI_Comm comm, const std::vector<std::uint64_t>& all,
                                     const std::size_t n_own)
{
  std::vector<int> counts, starts(1, 0);
  for (const std::size_t n : dealii::Utilities::MPI::gather(comm, n_own)) {
    counts.push_back(static_cast<int>(n));
    starts.push_back(starts.back() + counts.back());
  }
  std::vector<std::uint64_t> own(n_own);
  const int error = MPI_Scatterv(all.data(), counts.data(), starts.data(), MPI_UINT64_T, own.data(),
                                 static_cast<int>(n_own), MPI_UINT64_T, 0, comm);
  AssertThrowMPI(error);
  return own;
}

} // namespace

/// An own unknown is known by the first cell that has it, which is an own one or a neighbour, and
/// by its place there.
template <int dim>
PartitionIndependentOrder<dim>::PartitionIndependentOrder(const DofLayout<dim>& layout)
    : layout(layout)
{
  const auto owned = layout.dof_handler().locally_owned_dofs();
  std::map<dealii::types::global_dof_index, Key> first;
  std::vector<Key> keys;
  std::vector<dealii::types::global_dof_index> of_cell;
  for (const auto& cell : layout.dof_handler().active_cell_iterators()) {
    if (cell->is_artificial())
      continue;
    const unsigned int number = Mesh<dim>::number_of(cell);
    layout.unknowns(cell, of_cell);
    for (unsigned int i = 0; i < of_cell.size(); ++i)
      if (owned.is_element(of_cell[i])) {
        Key& key = first.emplace(of_cell[i], Key(number, i)).first->second;
        key = std::min(key, Key(number, i));
      }
    if (cell->is_locally_owned())
      keys.emplace_back(number, 0);
  }
  cells = places(keys);
  keys.clear();
  for (const auto& [index, key] : first) {
    indices.push_back(index);
    keys.push_back(key);
  }
  unknowns = places(keys);
}

template <int dim>
typename PartitionIndependentOrder<dim>::Places
PartitionIndependentOrder<dim>::places(const std::vector<Key>& own) const
{
  const MPI_Comm comm = layout.communicator();
  const std::vector<Key> keys = joined(comm, own);
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](const std::size_t k, const std::size_t l) { return keys[k] < keys[l]; });
  Places result;
  result.all.resize(keys.size());
  for (std::size_t place = 0; place < order.size(); ++place)
    result.all[order[place]] = place;
  result.own = dealt_out(comm, result.all, own.size());
  result.total = dealii::Utilities::MPI::sum<std::uint64_t>(own.size(), comm);
  return result;
}

/// Equally many values for each of the places.
template <int dim>
std::vector<double> PartitionIndependentOrder<dim>::sorted(const Places& places,
                                                           const std::vector<double>& own) const
{
  const std::vector<double> gathered = joined(layout.communicator(), own);
  const std::size_t n = places.all.empty() ? 0 : gathered.size() / places.all.size();
  std::vector<double> result(gathered.size());
  for (std::size_t k = 0; k < places.all.size(); ++k)
    std::copy_n(gathered.begin() + k * n, n, result.begin() + places.all[k] * n);
  return result;
}

template <int dim>
std::vector<double> PartitionIndependentOrder<dim>::collect(const BlockVector& x) const
{
  std::vector<double> own;
  for (const auto index : indices)
    own.push_back(x(index));
  return sorted(unknowns, own);
}

template <int dim>
std::vector<double>
PartitionIndependentOrder<dim>::collect(const std::vector<double>& internal) const
{
  return sorted(cells, internal);
}

template <int dim>
bool PartitionIndependentOrder<dim>::distribute(const std::vector<double>& all,
                                                BlockVector& x) const
{
  if (all.size() != unknowns.total)
    return false;
  x.zero_out_ghost_values();
  for (std::size_t k = 0; k < indices.size(); ++k)
    x(indices[k]) = all[unknowns.own[k]];
  x.update_ghost_values();
  return true;
}

template <int dim>
bool PartitionIndependentOrder<dim>::distribute(const std::vector<double>& all,
                                                std::vector<double>& internal) const
{
  if (cells.own.empty())
    return true;
  const std::size_t n = internal.size() / cells.own.size();
  if (all.size() != cells.total * n)
    return false;
  for (std::size_t k = 0; k < cells.own.size(); ++k)
    std::copy_n(all.begin() + cells.own[k] * n, n, internal.begin() + k * n);
  return true;
}

template class PartitionIndependentOrder<2>;
template class PartitionIndependentOrder<3>;

} // namespace thelma
