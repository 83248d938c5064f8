#include <thelma/elements/cell_points.h>
#include <thelma/output/observables.h>

#include <deal.II/base/mpi.h>

#include <cstring>
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
    auto& [start, past, work, loads, heat, entropy, produced] = sums;
    const Stock now = stock(scene);
    if (!scene.state.rates) // time has not begun
      sums = {now, now, 0., 0., 0., 0., 0.};
    else
      loads += load_work(scene);
    const double dt = scene.state.time - past.time;
    // What jumps at time 0 has no rate before the first step.
    const double before = past.time > 0. ? 0.5 : 0., after = 1. - before;
    work += 0.5 * (past.voltage + now.voltage) * (now.charge - past.charge);
    heat += now.walls.thermal - past.walls.thermal +
            dt * (before * past.inflow.heat + after * now.inflow.heat);
    entropy += now.walls.entropy - past.walls.entropy +
               dt * (before * past.inflow.entropy + after * now.inflow.entropy);
    produced += dt * (before * past.production + after * now.production);
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

  std::vector<double> memory() const override
  {
    std::vector<double> numbers(sizeof(Sums) / sizeof(double));
    std::memcpy(numbers.data(), &sums, sizeof(Sums));
    return numbers;
  }

  void remember(const std::vector<double>& numbers) override
  {
    std::memcpy(&sums, numbers.data(), sizeof(Sums));
  }

private:
  struct Stock {
    Energies stored, walls; ///< of the body, of the nodes of its walls
    HeatInflow inflow;
    double time, voltage, charge, production; ///< s, kV, uC, mW/K
  };

  /// What has come together since the start.
  struct Sums {
    Stock start, past;
    double work, loads, heat, entropy, produced;
  };

  Stock stock(const Scene<dim>& scene) const
  {
    Energies own = scene.system.energies(), walls;
    if (scene.layout.has(Field::temperature)) {
      own.add(1., scene.heat.stored(scene.state, theta_0));
      walls = scene.heat.stored_in_walls(scene.state, theta_0);
    }
    const std::vector<double> parts{own.elastic,   own.electric,  own.thermal,   own.entropy,
                                    walls.thermal, walls.entropy, charge(scene), production(scene)};
    std::vector<double> total(parts.size());
    dealii::Utilities::MPI::sum(parts, scene.layout.communicator(), total);
    return {{total[0], total[1], total[2], total[3]},
            {0., 0., total[4], total[5]},
            scene.state.inflow,
            scene.state.time,
            scene.state.voltage,
            total[6],
            total[7]};
  }

  /// What dead loads and pressures have done since the last accepted state, in mJ.
  static double load_work(const Scene<dim>& scene)
  {
    const auto& path = scene.state.path();
    const BlockVector& before = path[path.size() - 2].x;
    BlockVector way = scene.state.x, forces = scene.system.loads_at(scene.state.x);
    way.zero_out_ghost_values();
    way -= before;
    forces += scene.system.loads_at(before);
    return 0.5 * (forces * way);
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
  Sums sums{};
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
