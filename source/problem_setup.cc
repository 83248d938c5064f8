// What a run is set up from, and all that is wrong with it.

#include <thelma/base/error.h>
#include <thelma/output/curve.h>
#include <thelma/problem.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace thelma
{

template <int dim>
void Problem<dim>::setup()
{
  find_complaints();
  complaints.raise();
  state.theta = theta;
  state.x = layout.new_vector();
  if (layout.has(Field::temperature))
    state.x.block(layout.block(Field::temperature)) = theta_start;
  system.setup();
  if (pressure.exist())
    system.set_pressure(pressure);
  transient.setup(system, loading.voltage(1.), theta);
  if (!system.is_symmetric() && system.knows_stability())
    isothermal.setup(system);
  predictor.setup(system.element(), system.uses_multigrid());
  state.start();

  outcome.modelled = layout.summary();
  for (const std::vector<std::string>& lines :
       {mesh.remarks(), materials.summary(theta), materials.doubts()})
    outcome.modelled.insert(outcome.modelled.end(), lines.begin(), lines.end());
  outcome.modelled.push_back(loading.description());
  outcome.modelled.push_back(system.solver_description());
  if (layout.is_transient())
    for (const std::string& line : transient.summary())
      outcome.modelled.push_back(line);
  if (const std::string sentence = doubt_about_thickness(); !sentence.empty())
    outcome.modelled.push_back(sentence);
  for (const std::string& sentence : results.remarks())
    outcome.modelled.push_back(sentence);
  for (const std::string& sentence : idle_entries())
    outcome.modelled.push_back(sentence);
  outcome.cells = mesh.n_cells();
  outcome.imbalance = system.imbalance();
  outcome.halo = system.halo();
  for (const Field field : layout.fields())
    outcome.unknowns[field_name(field)] = layout.n_dofs(field);
}

/// Sets up all that may find fault with the scene. What seems to be missing may only be misspelt,
/// and what an entry means may hang on a choice beside it: where these could not be read, only that
/// is said.
template <int dim>
void Problem<dim>::find_complaints()
{
  Complaints found;
  check_and_set_up(found);
  const std::vector<std::string> earlier = complaints.sentences();
  for (const std::string& sentence : found.sentences()) {
    const std::string entry = sentence.substr(0, sentence.find(':')),
                      section = sentence.substr(0, sentence.find_first_of(",:/")),
                      guess = "did you mean '" + section.substr(section.find(' ') + 1) + "'";
    const auto explains = [&](const std::string& other) {
      const auto has = [&](const std::string& text) {
        return other.find(text) != std::string::npos;
      };
      std::smatch unread;
      std::regex_search(other, unread, std::regex("section [^:]*, entry '[^']*'"));
      return has(entry) || has(guess) || (has(section) && (has("unknown ") || has("be one of "))) ||
             (!unread.empty() && sentence.find(unread.str()) != std::string::npos);
    };
    if (std::none_of(earlier.begin(), earlier.end(), explains))
      complaints.add(sentence);
  }
}

template <int dim>
void Problem<dim>::check_and_set_up(Complaints& found)
{
  bool has_loading = false;
  if (found.allow([&]() { materials.check(theta); })) {
    found.allow([&]() { theta_start = materials.reference_temperature(); });
    has_loading = found.allow([&]() { loading.setup(materials, theta); });
  }
  const bool has_amplitudes = found.allow([&]() { transient.read_amplitudes(); });
  const bool has_mesh = found.allow([&]() {
    const auto timer = timings.measure("mesh");
    mesh.read(scene_folder, [this](const WholeMesh<dim>& whole) {
      if (picture_folder.empty())
        return;
      try {
        create_folder(picture_folder);
        write_file(picture_folder + "/mesh.vtu", picture(whole));
        mesh_is_drawn = true;
      } catch (const std::runtime_error&) { // nothing is wrong with the scene
      }
    });
  });
  if (!has_mesh || !found.allow([&]() { layout.setup(mesh, materials); }))
    return;
  const bool has_conditions = found.allow([&]() { conditions.setup(mesh, layout); });
  if (layout.has(Field::temperature))
    found.allow([&]() { materials.check_heat(layout.is_transient(), transient.makes_heat()); });
  if (has_conditions && found.allow([&]() { nodal_heat.setup(mesh, layout, conditions); }) &&
      has_amplitudes && layout.is_transient())
    found.allow([&]() { transient.check_walls(theta); });
  if (found.allow([&]() { choose_solvers(); }))
    found.allow([&]() { results.setup(scene(), theta); });
  found.allow([&]() { check_path(); });
  const bool has_forces = found.allow([&]() { dead_loads.setup(mesh, layout); });
  if (has_conditions) {
    if (found.allow([&]() { pressure.setup(mesh, layout, conditions); }) && has_forces &&
        has_loading)
      found.allow([&]() { check_stages(); });
    found.allow([&]() { path_following.setup(mesh, layout, conditions); });
  }
}

template <int dim>
void Problem<dim>::choose_solvers()
{
  if (path_following.is_automatic())
    system.require_inertia("Stepping/Continuation = automatic");
  else if (unstable_states == UnstableStates::reject)
    system.require_inertia("Stepping/Unstable states = reject");
  system.choose(layout.is_transient() ? Solved::deformation : Solved::all);
  if (layout.is_transient())
    transient.choose(system);
  else if (!system.is_symmetric()) {
    isothermal.choose(Solved::deformation, system);
    system.count_on(isothermal);
  }
}

/// A film thickness that the electrodes do not have makes another e of every voltage.
template <int dim>
std::string Problem<dim>::doubt_about_thickness() const
{
  constexpr double rough = 0.1; // as where a film is not everywhere as thick
  if (!layout.has(Field::potential))
    return "";
  const double distance = electrode_distance(mesh, conditions.electrodes());
  const double ratio = loading.thickness() / distance;
  if (!(distance > 0.) || std::abs(ratio - 1.) < rough)
    return "";
  return "warning: Loading/Film thickness is " + as_text(loading.thickness()) +
         " mm, but the electrodes are " + as_text(distance) +
         " mm apart where they are nearest; e is V/h sqrt(eps/mu) with h = Film thickness";
}

#define INSTANTIATE(dim) template void Problem<dim>::setup();
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

} // namespace thelma
