#include <thelma/base/error.h>
#include <thelma/base/option_names.h>
#include <thelma/base/quantity.h>
#include <thelma/simulation/model.h>

#include <cmath>

namespace thelma
{

template <int dim>
Model<dim>::Model(const MPI_Comm comm, const ParameterFile& file, Timings& timings)
    : timings(timings), materials(file), mesh(comm),
      system(layout, conditions, loads, storage, state, settings, timings),
      isothermal(layout, conditions, loads, storage, state, settings, timings),
      heated(layout, conditions, loads, storage, state, settings, timings),
      predictor(layout, conditions, state)
{
}

template <int dim>
void Model<dim>::declare(dealii::ParameterHandler& prm)
{
  mesh.declare(prm);
  materials.declare(prm);
  layout.declare(prm);
  settings.declare(prm);
  conditions.declare(prm);
  {
    const Section section(prm, {"Temperature"});
    add_quantity(
        prm, "Value", theta,
        "Uniform temperature; where the temperature is a field, its first guess or initial "
        "value and the temperature at which e is defined.",
        Quantity("K", 1., 1e4));
  }
  {
    const Section section(prm, {"Stepping"});
    OptionNames<StaticStates>(
        {{"relaxed", StaticStates::relaxed}, {"instantaneous", StaticStates::instantaneous}})
        .declare(prm, "Static states", static_states,
                 "What viscoelastic branches do before time begins, and in scenes without time: "
                 "`relaxed`: they have had time to relax; `instantaneous`: no time to flow, as "
                 "after sudden loads.");
  }
  loads.declare(prm);
  loading.declare(prm);
}

template <int dim>
typename Model<dim>::Parts
Model<dim>::check(const std::string& folder,
                  const std::function<void(const WholeMesh<dim>&)>& visit, InputErrors& found)
{
  Parts stand;
  bool has_loading = false;
  double theta_start = theta;
  if (found.collect([&]() { materials.check(theta); })) {
    found.collect([&]() { theta_start = materials.reference_temperature(); });
    has_loading = found.collect([&]() { loading.setup(materials, theta, loads.stage_names()); });
  }
  const bool has_mesh = found.collect([&]() {
    const auto timer = timings.measure("mesh");
    mesh.read(folder, visit);
  });
  stand.layout = has_mesh && found.collect([&]() { layout.setup(mesh, materials); });
  if (!stand.layout)
    return stand;
  stand.conditions = found.collect([&]() { conditions.setup(mesh, layout); });
  if (stand.conditions)
    for (const auto& wall : conditions.walls())
      found.collect([&]() { materials.check_at({wall.second, "Temperature/Fixed"}); });
  const bool has_loads = found.collect([&]() {
    loads.setup({mesh, layout, stand.conditions ? &conditions : nullptr,
                 has_loading ? &loading : nullptr, theta_start, theta});
  });
  if (stand.conditions && has_loading && has_loads)
    found.collect([&]() { loads.check(loading.stages()); });
  if (stand.conditions)
    storage.setup(layout, conditions);
  return stand;
}

template <int dim>
void Model<dim>::setup()
{
  state.theta = theta;
  state.theta_start = materials.reference_temperature();
  state.holds_without_time = static_states == StaticStates::instantaneous;
  state.x = layout.new_vector();
  if (layout.has(Field::temperature))
    state.x.block(layout.block(Field::temperature)) = state.theta_start;
  system.setup();
  if (layout.has_transient_temperature())
    heated.setup();
  if (!system.linear.is_symmetric() && system.stability.is_known())
    isothermal.setup();
  predictor.setup(system.cells.formulation(), system.linear.uses_multigrid());
  state.start();
}

template <int dim>
std::vector<std::string> Model<dim>::summary() const
{
  std::vector<std::string> lines = layout.summary();
  for (const std::vector<std::string>& more :
       {mesh.remarks(), materials.summary(theta), materials.doubts()})
    lines.insert(lines.end(), more.begin(), more.end());
  lines.push_back(loading.description());
  lines.push_back(system.linear.description() + system.stability.remark());
  if (const std::string sentence = doubt_about_thickness(); !sentence.empty())
    lines.push_back(sentence);
  return lines;
}

/// A film thickness that the electrodes do not have makes another e of every voltage.
template <int dim>
std::string Model<dim>::doubt_about_thickness() const
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

template class Model<2>;
template class Model<3>;

} // namespace thelma
