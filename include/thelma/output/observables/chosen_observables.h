#pragma once

#include <thelma/base/input_errors.h>
#include <thelma/base/parameters.h>
#include <thelma/output/observables/observables.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace thelma
{

/// The observables that a scene names in Output/Observables, in this order: by their kind, or by a
/// free name whose section Observables/<name> says the `Kind`.
template <int dim>
class ChosenObservables
{
public:
  /// Takes names and kinds from @p file, so that the observables can declare their entries.
  explicit ChosenObservables(const ParameterFile& file);

  /// The entry of the section Output.
  void declare_names(dealii::ParameterHandler& prm) const;

  /// The sections of the observables.
  void declare(dealii::ParameterHandler& prm);

  /// @p found collects what is wrong.
  void setup(const ObservableInput<dim>& scene, InputErrors& found);

  /// No name may make a second column of one that is in @p curve, which has those of all
  /// observables.
  void require_distinct(const std::vector<std::string>& curve, InputErrors& found) const;

  std::vector<std::string> columns() const;

  /// What the observables say of their columns in this scene.
  std::vector<std::string> remarks() const;

  /// A number for each column.
  std::vector<double> evaluate(const ObservableInput<dim>& scene);

  /// Throws InputError, with @p place in the sentence, if no observable has @p column.
  void require_column(const std::string& column, const std::string& place) const;

  /// What @p column is in the present state.
  double value(const ObservableInput<dim>& scene, const std::string& column);

  /// What the observables remember of earlier steps.
  template <class Archive>
  void serialize(Archive& archive, unsigned int)
  {
    std::vector<std::vector<double>> memories;
    for (const auto& observable : observed)
      memories.push_back(observable->saved());
    archive& memories;
    for (std::size_t i = 0; i < observed.size(); ++i)
      observed[i]->restore(memories[i]);
  }

private:
  using List = std::vector<std::unique_ptr<Observable<dim>>>;

  void add_unlisted(const ParameterFile& file, const std::vector<std::string>& listed);

  /// The observable of this name, if its kind is known.
  std::unique_ptr<Observable<dim>> create(const std::string& name) const;
  void declare_kind(dealii::ParameterHandler& prm, const std::string& name) const;

  std::map<std::string, std::string> kinds; ///< of the names whose sections say one
  List observed;
  List unlisted;                    ///< have a section, but Output does not name them
  std::vector<std::string> unnamed; ///< their names, unless one of Output may be misspelt
  std::map<std::string, std::vector<std::string>>
      unknown; ///< names without a known kind, and the entries of their sections
};

} // namespace thelma
