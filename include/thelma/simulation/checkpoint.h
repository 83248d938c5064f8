#pragma once

#include <thelma/output/run_output.h>
#include <thelma/simulation/phases.h>

#include <string>

namespace thelma
{

/// What decides how a run goes on, as text and back. Between two steps that is little: the next one
/// makes a tangent of its own and prescribes what belongs to its load.
template <int dim>
struct Checkpoint {
  std::string scene;     ///< parameters
  std::string mesh_file; ///< for messages
  Model<dim>& model;
  Strategies<dim>& strategies;
  Phases<dim>& phases;
  Outcome& outcome;
  RunOutput<dim>& output;

  std::string content();

  /// Take up the run of the @p content. Throws InputError for one of another scene, mesh or
  /// program; with @p if_it_fits such a one only returns false.
  bool restore(const std::string& content, bool if_it_fits);

private:
  std::string mismatch(const std::string& by, const std::string& earlier_scene,
                       std::uint32_t body) const;
  template <class Archive>
  void serialize(Archive& archive);
  template <class Archive>
  void serialize_electrodes(Archive& archive);
};

} // namespace thelma
