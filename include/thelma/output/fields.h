#pragma once

#include <thelma/output/observables/observables.h>

#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// Writes u, phi, theta and the point quantities P, D, E, J as VTU with a .pvd over all steps.
template <int dim>
class FieldWriter
{
public:
  void declare(dealii::ParameterHandler& prm);

  /// Remove what an earlier run has written; to be called by one rank.
  static void remove_old(const std::string& folder);

  /// Write the state as number @p step, if fields are wanted for it.
  void write(const ObservableInput<dim>& scene, const std::string& folder, unsigned int step,
             double load, bool last);

  /// Write a displacement and the other fields that go with it, as the next mode.
  void write_mode(const ObservableInput<dim>& scene, const std::string& folder, BlockVector mode);

  /// Write the .pvd.
  void write_list(MPI_Comm comm, const std::string& folder) const;

  /// What has been written so far.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    archive& n_modes& written;
  }

private:
  enum class Frequency { every, last, none };

  unsigned int n_modes = 0;
  Frequency frequency = Frequency::last;
  std::vector<std::pair<double, std::string>> written;
};

} // namespace thelma
