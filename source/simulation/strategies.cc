#include <thelma/base/error.h>
#include <thelma/simulation/strategies.h>

namespace thelma
{

template <int dim>
Strategies<dim>::Strategies(Model<dim>& model)
    : model(model), heating(model.system, model.state, model.predictor, equilibrium, model.timings),
      load_steps(model.system, model.state, model.predictor, equilibrium, model.timings),
      arc_length(model.system, model.state, model.predictor, equilibrium),
      time_steps(model.system, model.heated, model.layout, model.conditions, model.loads,
                 model.state, model.predictor, equilibrium),
      ramp(model.loads, model.state), heating_path(model, ramp)
{
}

template <int dim>
void Strategies<dim>::declare(dealii::ParameterHandler& prm)
{
  load_steps.declare(prm);
  equilibrium.declare(prm);
  arc_length.declare(prm);
  time_steps.declare(prm);
}

template <int dim>
void Strategies<dim>::check(const bool has_conditions, InputErrors& found)
{
  const auto in_time = [&]() { return model.layout.is_transient(); };
  found.collect([&]() {
    if (follow_path() && in_time())
      throw InputError("section Stepping, entry 'Continuation': in time there is no load to be "
                       "found; choose load");
    if (!follow_path() && arc_length.chooses_branch())
      throw InputError("section Stepping, entry 'Branch': only a path that is followed takes one; "
                       "set Stepping/Continuation to automatic, or remove the entry");
    if (!follow_path() && !model.loading.until().empty())
      throw InputError("section Loading, entry 'Until': only a path that is followed ends so; set "
                       "Stepping/Continuation to automatic, or remove the entry");
  });
  if (model.layout.has(Field::temperature))
    found.collect([&]() {
      model.materials.check_heat(model.layout.has_transient_temperature(),
                                 time_steps.makes_heat_by_power());
    });
  if (has_conditions)
    found.collect([&]() { arc_length.setup(model.mesh, model.layout, model.conditions); });
}

template <int dim>
void Strategies<dim>::choose_solvers()
{
  DiscreteSystem<dim>& system = model.system;
  if (follow_path()) {
    equilibrium.require_stable();
    model.settings.counts_for = "Stepping/Continuation = automatic";
  } else if (equilibrium.rejects_by_choice())
    model.settings.counts_for = "Stepping/Unstable states = reject";
  const bool has_heat_in_time = model.layout.has_transient_temperature();
  system.choose(has_heat_in_time ? Solved::deformation : Solved::all);
  time_steps.control(!model.materials.one_that_remembers().empty());
  if (has_heat_in_time)
    time_steps.choose();
  else if (!system.linear.is_symmetric()) {
    model.isothermal.choose(Solved::deformation);
    system.stability.count_on(model.isothermal.stability);
  }
}

template struct Strategies<2>;
template struct Strategies<3>;

} // namespace thelma
