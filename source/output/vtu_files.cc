#include <thelma/base/error.h>
#include <thelma/output/curve.h>
#include <thelma/output/vtu_files.h>

#include <sstream>
#include <vector>

namespace thelma
{

template <int dim>
std::string VtuFiles<dim>::write(const std::string& folder, const std::string& name_and_step,
                                 const MPI_Comm comm, const unsigned int group_size) const
{
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(comm),
                     n_ranks = dealii::Utilities::MPI::n_mpi_processes(comm);
  const auto piece = [&](const unsigned int group) {
    return name_and_step + "." + std::to_string(group) + ".vtu";
  };
  std::string record = name_and_step + ".pvtu";
  MPI_Comm members = MPI_COMM_NULL;
  MPI_Comm_split(comm, static_cast<int>(rank / group_size), static_cast<int>(rank), &members);
  const std::string content = collect(members);
  MPI_Comm_free(&members);

  bool failed = false;
  try {
    if (rank % group_size == 0)
      write_file(folder + "/" + piece(rank / group_size), content);
    if (rank == 0) {
      std::vector<std::string> pieces;
      for (unsigned int first = 0; first < n_ranks; first += group_size)
        pieces.push_back(piece(first / group_size));
      std::ostringstream list;
      this->write_pvtu_record(list, pieces);
      write_file(folder + "/" + record, list.str());
    }
  } catch (const WriteError&) {
    failed = true;
  }
  if (dealii::Utilities::MPI::logical_or(failed, comm))
    throw WriteError("cannot write the fields into '" + folder +
                     "'; choose another --output folder or free disk space");
  return record;
}

/// A file's text with the parts of all @p members, on the first of them.
template <int dim>
std::string VtuFiles<dim>::collect(const MPI_Comm members) const
{
  const dealii::DataOutBase::VtkFlags flags;
  std::ostringstream own, all;
  dealii::DataOutBase::write_vtu_main(this->get_patches(), this->get_dataset_names(),
                                      this->get_nonscalar_data_ranges(), flags, own);
  dealii::DataOutBase::write_vtu_header(all, flags);
  for (const std::string& part : dealii::Utilities::MPI::gather(members, own.str()))
    all << part;
  dealii::DataOutBase::write_vtu_footer(all);
  return all.str();
}

template class VtuFiles<2>;
template class VtuFiles<3>;

} // namespace thelma
