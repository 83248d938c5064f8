#include <thelma/base/error.h>
#include <thelma/elements/cell_points.h>
#include <thelma/output/observables/observables.h>

#include <deal.II/base/mpi.h>

#include <cstring>
#include <optional>
#include <type_traits>
#include <utility>

namespace thelma
{
namespace
{

/// The first and the second law (theory.md, eqs. 42, 43, 44): what is stored, what came in through
/// electrodes, loads, supports and walls, what conduction made of entropy, and what is missing. In
/// time since time 0, otherwise since the first row of the curve, with the heat that a bath gives.
template <int dim>
class Ledger final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void setup(const ObservableInput<dim>& scene) override
  {
    if (scene.layout.has(Field::temperature) && !scene.layout.has_transient_temperature())
      throw InputError(
          "section Output, entry 'Observables': the ledger is not available with a steady "
          "temperature field; leave it out, or set Temperature/Model = uniform or transient");
    counts_flow = !scene.materials.one_that_remembers().empty();
    rule.emplace(scene.layout, scene.layout.degree() + 1);
    theta_0 = scene.materials.reference_temperature();
  }

  std::vector<std::string> columns_of_kind() const override
  {
    std::vector<std::string> columns{"ledger_elastic_mJ",
                                     "ledger_electric_mJ",
                                     "ledger_thermal_mJ",
                                     "ledger_electrode_work_mJ",
                                     "ledger_load_work_mJ",
                                     "ledger_support_work_mJ",
                                     "ledger_heat_mJ",
                                     "ledger_energy_missing_mJ",
                                     "ledger_entropy_mJ_per_K",
                                     "ledger_entropy_inflow_mJ_per_K",
                                     "ledger_entropy_produced_mJ_per_K",
                                     "ledger_entropy_missing_mJ_per_K"};
    if (counts_flow)
      columns.emplace_back("ledger_dissipated_mJ");
    return columns;
  }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    const Stock now = stock(scene);
    if (!has_begun || (scene.layout.is_transient() && !scene.state.rates)) { // time has not begun
      has_begun = true;
      sums = {now.numbers, now.numbers, 0., 0., 0., 0., 0., 0., 0.};
    } else
      add_work(scene, now);
    sums.produced += now.numbers.dissipated.entropy;
    sums.dissipated += now.numbers.dissipated.energy;
    if (scene.state.rates && scene.layout.has(Field::temperature))
      add_heat(now.numbers);
    else
      add_heat_of_bath(now.numbers);
    sums.past = now.numbers;
    electrodes = now.electrodes;
    loads = now.loads;
    before = scene.state.x;
    return values(now.numbers.stored);
  }

  std::vector<double> saved() const override
  {
    std::vector<double> numbers(sizeof(Sums) / sizeof(double));
    std::memcpy(numbers.data(), &sums, sizeof(Sums));
    numbers.push_back(has_begun);
    numbers.push_back(loads.levels.size());
    for (const std::vector<double>* of_loads : {&loads.levels, &loads.work})
      numbers.insert(numbers.end(), of_loads->begin(), of_loads->end());
    for (const auto& [voltage, charge] : electrodes)
      numbers.insert(numbers.end(), {voltage, charge});
    return numbers;
  }

  void restore(const std::vector<double>& numbers) override
  {
    static_assert(std::is_trivially_copyable_v<Sums>);
    std::memcpy(static_cast<void*>(&sums), numbers.data(), sizeof(Sums));
    std::size_t k = sizeof(Sums) / sizeof(double);
    has_begun = numbers[k++] != 0.;
    const auto n_loads = static_cast<std::size_t>(numbers[k++]);
    for (std::vector<double>* of_loads : {&loads.levels, &loads.work}) {
      of_loads->assign(numbers.data() + k, numbers.data() + k + n_loads);
      k += n_loads;
    }
    for (electrodes.clear(); k < numbers.size(); k += 2)
      electrodes.emplace_back(numbers[k], numbers[k + 1]);
    before.reset();
  }

private:
  struct Numbers {
    Energies stored, walls; ///< of the body, of the nodes of its walls
    HeatInflow inflow;
    double time, theta, production; ///< s, K, mW/K
    Dissipated<> dissipated;        ///< since the state before, in mJ and mJ/K
  };

  /// Potential in kV and charge in uC of every electrode.
  using Electrodes = std::vector<std::pair<double, double>>;

  /// Of every load: its level, and its work per level in mJ, if it prescribes values.
  struct Levels {
    std::vector<double> levels, work;
  };

  struct Stock {
    Numbers numbers;
    Electrodes electrodes;
    Levels loads;
  };

  /// What has come together since the start.
  struct Sums {
    Numbers start, past;
    double electric, loads, supports, heat, entropy, produced, dissipated;
  };

  std::vector<double> values(const Energies& e) const
  {
    const Energies& start = sums.start.stored;
    const double change =
        e.elastic + e.electric + e.thermal - (start.elastic + start.electric + start.thermal);
    std::vector<double> all{
        e.elastic,     e.electric,
        e.thermal,     sums.electric,
        sums.loads,    sums.supports,
        sums.heat,     change - sums.electric - sums.loads - sums.supports - sums.heat,
        e.entropy,     sums.entropy,
        sums.produced, e.entropy - start.entropy - sums.entropy - sums.produced};
    if (counts_flow)
      all.push_back(sums.dissipated);
    return all;
  }

  Stock stock(const ObservableInput<dim>& scene) const
  {
    Energies own = scene.system.cells.energies(), walls;
    if (scene.layout.has(Field::temperature)) {
      own.add(1., scene.storage.stored(scene.state, theta_0));
      walls = scene.storage.stored_in_walls(scene.state, theta_0);
    }
    const BlockVector& reactions = scene.system.reactions();
    std::vector<double> parts{own.elastic,   own.electric,  own.thermal,      own.entropy,
                              walls.thermal, walls.entropy, production(scene)};
    const Dissipated<> flow = dissipated(scene);
    parts.insert(parts.end(), {flow.energy, flow.entropy});
    for (const Electrode& electrode : scene.conditions.electrodes())
      parts.push_back(-electrode.own_sum(reactions));
    for (std::size_t i = 0; i < scene.loads.size(); ++i)
      parts.push_back(scene.loads[i].work_per_level(reactions));
    std::vector<double> total(parts.size());
    dealii::Utilities::MPI::sum(parts, scene.layout.communicator(), total);
    Stock now{{{total[0], total[1], total[2], total[3]},
               {0., 0., total[4], total[5]},
               scene.state.inflow,
               scene.state.time,
               scene.state.theta,
               total[6],
               {total[7], total[8]}},
              {},
              {scene.loads.levels(), {}}};
    std::size_t k = 9;
    for (const Electrode& electrode : scene.conditions.electrodes())
      now.electrodes.emplace_back(potential(electrode, scene.layout, scene.state.x), total[k++]);
    now.loads.work.assign(total.data() + k, total.data() + total.size());
    return now;
  }

  /// By the trapezoidal rule, as all that follows.
  void add_work(const ObservableInput<dim>& scene, const Stock& now)
  {
    for (std::size_t e = 0; e < electrodes.size(); ++e)
      sums.electric += 0.5 * (electrodes[e].first + now.electrodes[e].first) *
                       (now.electrodes[e].second - electrodes[e].second);
    for (std::size_t i = 0; i < loads.levels.size(); ++i)
      sums.supports +=
          0.5 * (loads.work[i] + now.loads.work[i]) * (now.loads.levels[i] - loads.levels[i]);
    const auto& path = scene.state.path();
    if (!before && path.size() > 1) // the last row before a checkpoint
      before = path[path.size() - 2].x;
    if (!before)
      return;
    sums.loads +=
        scene.loads.work(scene.layout, scene.state, {loads.levels, sums.past.time, *before},
                         {now.loads.levels, now.numbers.time, scene.state.x});
  }

  void add_heat(const Numbers& now)
  {
    const Numbers& past = sums.past;
    const auto [dt, early, late] = trapezium(now);
    sums.heat += now.walls.thermal - past.walls.thermal +
                 dt * (early * past.inflow.heat + late * now.inflow.heat);
    sums.entropy += now.walls.entropy - past.walls.entropy +
                    dt * (early * past.inflow.entropy + late * now.inflow.entropy);
    sums.produced += dt * (early * past.production + late * now.production);
  }

  struct Trapezium {
    double dt, early, late;
  };

  /// What jumps at time 0 has no rate before the first step.
  Trapezium trapezium(const Numbers& now) const
  {
    const double early = sums.past.time > 0. ? 0.5 : 0.;
    return {now.time - sums.past.time, early, 1. - early};
  }

  /// A body whose temperature is prescribed takes theta d(eta) but for what it dissipates itself.
  void add_heat_of_bath(const Numbers& now)
  {
    const double gained = now.stored.entropy - sums.past.stored.entropy;
    sums.heat += 0.5 * (sums.past.theta + now.theta) * gained - now.dissipated.energy;
    sums.entropy += gained - now.dissipated.entropy;
  }

  /// By flow over the step to the state, which is the last accepted one, in the own cells.
  Dissipated<> dissipated(const ObservableInput<dim>& scene) const
  {
    Dissipated<> sum;
    if (!counts_flow)
      return sum;
    scene.system.cells.for_each([&](const CellView<dim>& view) {
      if (view.memory.older == nullptr)
        return;
      const PointGeometry<dim>* points = rule->of_cell(view.index);
      for (unsigned int q = 0; q < rule->basis().n_points; ++q) {
        const Dissipated<> own =
            view.cell.material->dissipated(view.memory.accepted(1, q), view.memory.accepted(0, q));
        sum.energy += points[q].JxW * own.energy;
        sum.entropy += points[q].JxW * own.entropy;
      }
    });
    return sum;
  }

  /// -Q . Grad theta / theta^2 over the own cells.
  double production(const ObservableInput<dim>& scene) const
  {
    double sum = 0.;
    scene.system.cells.for_each([&](const CellView<dim>& view) {
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
  bool has_begun = false, counts_flow = false;
  Sums sums{};
  Electrodes electrodes;             ///< at the last row
  Levels loads;                      ///< there
  std::optional<BlockVector> before; ///< nodal values there; not known after a checkpoint
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_ledger(const ObservableName& name)
{
  return std::make_unique<Ledger<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_ledger(const ObservableName&);
template std::unique_ptr<Observable<3>> make_ledger(const ObservableName&);

} // namespace thelma
