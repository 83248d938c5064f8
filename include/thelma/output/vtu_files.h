#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/data_out.h>

#include <string>

namespace thelma
{

/// Fields to be written as VTU, with a file for every few ranks: one for each would be too many in
/// a large run, and files that MPI writes in common leave ranks waiting for one that had no room.
template <int dim>
class VtuFiles : public dealii::DataOut<dim>
{
public:
  static constexpr unsigned int ranks_per_file = 16;

  /// Write NAME_STEP.*.vtu, and NAME_STEP.pvtu that lists them, into @p folder; returns the
  /// latter's name. Throws WriteError on all ranks if one has no room.
  std::string write(const std::string& folder, const std::string& name_and_step, MPI_Comm comm,
                    unsigned int group_size = ranks_per_file) const;

private:
  std::string collect(MPI_Comm members) const;
};

} // namespace thelma
