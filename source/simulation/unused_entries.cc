// What a scene sets and nothing reads.

#include <thelma/base/declared_entries.h>
#include <thelma/simulation/unused_entries.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// Entries of a section that have no effect @p if_so; without names, all of them.
struct Unused {
  bool if_so;
  std::string section;
  std::vector<std::string> entries;
  std::string reason;
};

} // namespace

template <int dim>
std::vector<std::string> unused_entries(const dealii::ParameterHandler& prm,
                                        const Model<dim>& model, const bool follows)
{
  const DeclaredEntries scene(prm);
  const bool in_time = model.layout.is_transient(),
             has_heat = model.layout.has_transient_temperature(),
             is_electric = model.layout.has(Field::potential),
             remembers = !model.materials.one_that_remembers().empty();
  std::vector<Unused> all{
      {std::stod(scene.value({"Mesh"}, "Imperfection")) == 0.,
       "Mesh",
       {"Imperfection shape"},
       "Imperfection is 0"},
      {!in_time, "Time", {}, "nothing evolves in time"},
      {in_time && !has_heat,
       "Time",
       {"Coupling", "Structural heat"},
       "no temperature field is transient"},
      {in_time && !has_heat && remembers,
       "Time",
       {"Tolerance"},
       "no temperature field is transient"},
      {in_time && !remembers, "Time", {"Strain tolerance"}, "no material has branches"}};
  if (in_time)
    for (const auto& [entry, reason] : model.loads.unused_amplitudes())
      all.push_back({true, "Time", {entry}, reason});
  const std::vector<Unused> others{
      {!is_electric,
       "Loading",
       {"Control", "Target", "Film thickness", "Film material"},
       "every region is passive"},
      {!follows, "Stepping", {"Most steps"}, "Continuation is not automatic"},
      {!remembers, "Stepping", {"Static states"}, "no material has branches"},
      {follows, "Stepping", {"Unstable states"}, "Continuation goes on through them"},
      {!model.system.linear.iterates(),
       "Linear solver",
       {"Tolerance", "Iterations"},
       "the solver is direct"},
      {scene.value({"Expectations"}, "Final values").empty(),
       "Expectations",
       {"Relative tolerance"},
       "there are no Final values"}};
  all.insert(all.end(), others.begin(), others.end());
  std::vector<std::string> sentences;
  for (const Unused& unused : all) {
    if (!unused.if_so)
      continue;
    std::vector<std::string> found;
    for (const std::string& entry : scene.changed({unused.section}))
      if (unused.entries.empty() ||
          std::find(unused.entries.begin(), unused.entries.end(), entry) != unused.entries.end())
        found.push_back(unused.section + "/" + entry);
    if (!found.empty())
      sentences.push_back("without effect: " + comma_separated(found) + ", because " +
                          unused.reason);
  }
  return sentences;
}

template std::vector<std::string> unused_entries(const dealii::ParameterHandler&, const Model<2>&,
                                                 bool);
template std::vector<std::string> unused_entries(const dealii::ParameterHandler&, const Model<3>&,
                                                 bool);

} // namespace thelma
