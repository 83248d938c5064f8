#include <thelma/elements/cell_points.h>
#include <thelma/output/observables.h>

#include <deal.II/base/mpi.h>

#include <optional>

namespace thelma
{
namespace
{

/// The first and the second law since time 0 (theory.md, eqs. 37, 38): what is stored, what came in
/// through electrodes, dead loads and walls, what conduction made of entropy, and what is missing.
template <int dim>
class Ledger final : public Observable<dim>
{
public:
  void setup(const Scene<dim>& scene) override
  {
    rule.emplace(scene.layout, scene.layout.degree() + 1);
    theta_0 = scene.materials.reference_temperature();
  }

  std::vector<std::string> columns() const override
  {
    return {"ledger_elastic_mJ",
            "ledger_electric_mJ",
            "ledger_thermal_mJ",
            "ledger_electrode_work_mJ",
            "ledger_load_work_mJ",
            "ledger_heat_mJ",
            "ledger_energy_missing_mJ",
            "ledger_entropy_mJ_per_K",
            "ledger_entropy_inflow_mJ_per_K",
            "ledger_entropy_produced_mJ_per_K",
            "ledger_entropy_missing_mJ_per_K"};
  }

  std::vector<double> evaluate(const Scene<dim>& scene) override
  {
    const Stock now = stock(scene);
    if (!scene.state.rates) // time has not begun
      begin(scene, now);
    const double dt = scene.state.time - past.time;
    // What jumps at time 0 has no rate before the first step.
    const double before = past.time > 0. ? 0.5 : 0., after = 1. - before;
    work += 0.5 * (past.voltage + now.voltage) * (now.charge - past.charge);
    heat += dt * (before * past.inflow.heat + after * now.inflow.heat);
    entropy += dt * (before * past.inflow.entropy + after * now.inflow.entropy);
    produced += dt * (before * past.production + after * now.production);
    loads += load_work(scene);
    past = now;
    const Energies& e = now.stored;
    const double change = e.elastic + e.electric + e.thermal -
                          (start.stored.elastic + start.stored.electric + start.stored.thermal);
    return {e.elastic,
            e.electric,
            e.thermal,
            work,
            loads,
            heat,
            change - work - loads - heat,
            e.entropy,
            entropy,
            produced,
            e.entropy - start.stored.entropy - entropy - produced};
  }

private:
  struct Stock {
    Energies stored;
    HeatInflow inflow;
    double time, voltage, charge, production; ///< s, kV, uC, mW/K
  };

  Stock stock(const Scene<dim>& scene) const
  {
    Energies own = scene.system.energies();
    if (scene.layout.has(Field::temperature))
      own.add(1., scene.heat.stored(scene.state, theta_0));
    const std::vector<double> sums{own.elastic, own.electric,  own.thermal,
                                   own.entropy, charge(scene), production(scene)};
    std::vector<double> total(sums.size());
    dealii::Utilities::MPI::sum(sums, scene.layout.communicator(), total);
    return {{total[0], total[1], total[2], total[3]},
            scene.state.inflow,
            scene.state.time,
            scene.state.voltage,
            total[4],
            total[5]};
  }

  void begin(const Scene<dim>& scene, const Stock& now)
  {
    past = start = now;
    work = loads = heat = entropy = produced = 0.;
    load_work(scene);
  }

  /// On the way from the last state, in mJ.
  double load_work(const Scene<dim>& scene)
  {
    BlockVector x = scene.state.x, forces = scene.system.present_loads();
    x.zero_out_ghost_values();
    double done = 0.;
    if (past_x.size() > 0) {
      BlockVector way = x;
      way -= past_x;
      done = 0.5 * (forces * way + past_forces * way);
    }
    past_x = x;
    past_forces = forces;
    return done;
  }

  static double charge(const Scene<dim>& scene)
  {
    const auto owned = scene.layout.dof_handler().locally_owned_dofs();
    double sum = 0.;
    for (const auto& [dof, factor] : scene.conditions.driven())
      if (owned.is_element(dof))
        sum -= factor * scene.system.reactions()(dof);
    return sum;
  }

  /// -Q . Grad theta / theta^2 over the own cells.
  double production(const Scene<dim>& scene) const
  {
    double sum = 0.;
    scene.system.for_each_cell([&](const CellView<dim>& view) {
      const CellPoints<dim> points(*rule, view);
      for (unsigned int q = 0; q < points.n_points; ++q) {
        const PointInput<double> input = points.at(q);
        const HeatFlux<> flux =
            view.cell.material->thermal.heat_flux(Kinematics<>(input.state.F), input.grad_theta);
        sum -= points.geometry[q].JxW * (flux.Q * input.grad_theta) /
               (input.state.theta * input.state.theta);
      }
    });
    return sum;
  }

  std::optional<Integration<dim>> rule;
  double theta_0 = 293.;
  Stock start{}, past{};
  BlockVector past_x, past_forces;
  double work = 0., loads = 0., heat = 0., entropy = 0., produced = 0.;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_ledger()
{
  return std::make_unique<Ledger<dim>>();
}

template std::unique_ptr<Observable<2>> make_ledger();
template std::unique_ptr<Observable<3>> make_ledger();

} // namespace thelma
