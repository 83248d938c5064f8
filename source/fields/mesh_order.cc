#include <thelma/fields/mesh_order.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace thelma
{
template <int dim>
MeshOrder<dim>::MeshOrder(const FieldLayout<dim>& layout) : layout(layout)
{
  constexpr auto unseen = std::numeric_limits<std::uint64_t>::max();
  std::vector<std::uint64_t> place(layout.dof_handler().n_dofs(), unseen);
  std::vector<dealii::types::global_dof_index> of_cell;
  for (const auto& cell : layout.dof_handler().active_cell_iterators()) {
    layout.unknowns(cell, of_cell);
    for (const auto index : of_cell)
      if (place[index] == unseen)
        place[index] = unknowns.total++;
    if (cell->is_locally_owned())
      cells.own.push_back(cells.total);
    ++cells.total;
  }
  for (const auto index : layout.dof_handler().locally_owned_dofs())
    if (place[index] != unseen) { // others have one that stands for them
      indices.push_back(index);
      unknowns.own.push_back(place[index]);
    }
  gather(unknowns);
  gather(cells);
}

template <int dim>
void MeshOrder<dim>::gather(Places& places) const
{
  const MPI_Comm comm = layout.communicator();
  const int count = static_cast<int>(places.own.size());
  places.counts = dealii::Utilities::MPI::gather(comm, count);
  std::vector<int> offsets(places.counts.size(), 0);
  for (std::size_t r = 1; r < offsets.size(); ++r)
    offsets[r] = offsets[r - 1] + places.counts[r - 1];
  if (!offsets.empty())
    places.all.resize(offsets.back() + places.counts.back());
  MPI_Gatherv(places.own.data(), count, MPI_UINT64_T, places.all.data(), places.counts.data(),
              offsets.data(), MPI_UINT64_T, 0, comm);
}

/// Equally many values for each of the places.
template <int dim>
std::vector<double> MeshOrder<dim>::sorted(const Places& places,
                                           const std::vector<double>& own) const
{
  const MPI_Comm comm = layout.communicator();
  const std::size_t n = dealii::Utilities::MPI::max(
      places.own.empty() ? std::size_t(0) : own.size() / places.own.size(), comm);
  std::vector<int> counts, offsets;
  int total = 0;
  for (const int count : places.counts) {
    counts.push_back(count * static_cast<int>(n));
    offsets.push_back(total);
    total += counts.back();
  }
  std::vector<double> gathered(total), result(total);
  MPI_Gatherv(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, gathered.data(), counts.data(),
              offsets.data(), MPI_DOUBLE, 0, comm);
  for (std::size_t k = 0; k < places.all.size(); ++k)
    std::copy_n(gathered.begin() + k * n, n, result.begin() + places.all[k] * n);
  return result;
}

template <int dim>
std::vector<double> MeshOrder<dim>::collect(const BlockVector& x) const
{
  std::vector<double> own;
  for (const auto index : indices)
    own.push_back(x(index));
  return sorted(unknowns, own);
}

template <int dim>
std::vector<double> MeshOrder<dim>::collect(const std::vector<double>& internal) const
{
  return sorted(cells, internal);
}

template <int dim>
bool MeshOrder<dim>::distribute(const std::vector<double>& all, BlockVector& x) const
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
bool MeshOrder<dim>::distribute(const std::vector<double>& all, std::vector<double>& internal) const
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

template class MeshOrder<2>;
template class MeshOrder<3>;

} // namespace thelma
