// What a scene sets and nothing reads.

#include <thelma/base/declared_entries.h>
#include <thelma/problem.h>

#include <algorithm>

namespace thelma
{
namespace
{

/// Entries of a section that have no effect @p if_so; without names, all of them.
struct Idle {
  bool if_so;
  std::string section;
  std::vector<std::string> entries;
  std::string reason;
};

} // namespace

/// Loads that nothing applies are bad input; settings may stand in a file for other cases of a
/// sweep, and are only told.
template <int dim>
std::vector<std::string> Problem<dim>::idle_entries() const
{
  const DeclaredEntries scene(prm);
  const auto is_empty = [&](const std::string& section, const std::string& entry) {
    return scene.value({section}, entry).empty();
  };
  const bool in_time = layout.is_transient(), is_electric = layout.has(Field::potential),
             follows = path_following.is_automatic();
  const std::vector<Idle> all{
      {std::stod(scene.value({"Mesh"}, "Imperfection")) == 0.,
       "Mesh",
       {"Imperfection shape"},
       "Imperfection is 0"},
      {!in_time, "Time", {}, "Temperature/Model is not transient"},
      {in_time && !is_electric, "Time", {"Voltage amplitude"}, "there is no potential"},
      {in_time && is_empty("Heat", "Flux") && is_empty("Heat", "Source"),
       "Time",
       {"Heat amplitude"},
       "there is neither Heat/Flux nor Heat/Source"},
      {in_time && is_empty("Temperature", "Fixed") && is_empty("Heat", "Convection"),
       "Time",
       {"Wall amplitude"},
       "there is neither Temperature/Fixed nor Heat/Convection"},
      {!is_electric,
       "Loading",
       {"Control", "Target", "Film thickness", "Film material"},
       "every region is passive"},
      {!follows, "Stepping", {"Most steps"}, "Continuation is not automatic"},
      {follows, "Stepping", {"Unstable states"}, "Continuation goes on through them"},
      {!system.iterates(), "Linear solver", {"Tolerance", "Iterations"}, "the solver is direct"},
      {is_empty("Expectations", "Final values"),
       "Expectations",
       {"Relative tolerance"},
       "there are no Final values"}};
  std::vector<std::string> sentences;
  for (const Idle& idle : all) {
    if (!idle.if_so)
      continue;
    std::vector<std::string> found;
    for (const std::string& entry : scene.changed({idle.section}))
      if (idle.entries.empty() ||
          std::find(idle.entries.begin(), idle.entries.end(), entry) != idle.entries.end())
        found.push_back(idle.section + "/" + entry);
    if (!found.empty())
      sentences.push_back("without effect: " + comma_separated(found) + ", because " + idle.reason);
  }
  return sentences;
}

template std::vector<std::string> Problem<2>::idle_entries() const;
template std::vector<std::string> Problem<3>::idle_entries() const;

} // namespace thelma
