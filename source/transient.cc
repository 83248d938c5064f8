#include <thelma/base/complaints.h>
#include <thelma/base/parameters.h>
#include <thelma/transient.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

namespace thelma
{

template <int dim>
void Transient<dim>::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  stepper.declare(prm);
  const Section section(prm, {"Time"});
  prm.add_parameter("Coupling", coupling,
                    "`staggered`: temperature, then displacement and potential, two symmetric "
                    "systems; `monolithic`: all at once, one unsymmetric system.",
                    Selection("staggered|monolithic"));
  prm.add_parameter("Structural heat", structural_heat,
                    "Heat made by deformation and field: `none`; `power`: H beside the constant "
                    "capacity c, as in the paper; `entropy`: theta times the rate of entropy, "
                    "which conserves energy.",
                    Selection("none|power|entropy"));
  const std::string form = ", an expression of t (s) or a table `0: 0, 2.5: 1`.";
  prm.add_parameter("Voltage amplitude", voltage_text, "Multiple of the voltage over time" + form,
                    Anything());
  prm.add_parameter("Wall amplitude", wall_text,
                    "Part of the way from Temperature/Value to the temperatures of walls and "
                    "surroundings" +
                        form,
                    Anything());
  prm.add_parameter("Heat amplitude", power_text, "Multiple of heat fluxes and sources" + form,
                    Anything());
}

template <int dim>
void Transient<dim>::read_amplitudes()
{
  struct Entry {
    std::string name;
    const std::string& text;
    std::optional<Amplitude>& amplitude;
  };
  Complaints complaints;
  for (const Entry& entry : {Entry{"Voltage amplitude", voltage_text, voltage_amplitude},
                             Entry{"Wall amplitude", wall_text, wall_amplitude},
                             Entry{"Heat amplitude", power_text, power_amplitude}})
    complaints.allow([&]() {
      const std::string place = "section Time, entry '" + entry.name + "'";
      entry.amplitude.emplace(place, entry.text);
      for (const double time : layout.is_transient() ? samples() : std::vector<double>())
        if (const double value = (*entry.amplitude)(time); !std::isfinite(value))
          throw InputError(place + ": it is " + as_text(value) + " at t = " + as_text(time) +
                           " s; write what is a number from 0 to Time/End");
    });
  complaints.raise();
  if (layout.is_transient())
    return;
  if (voltage_text != "1" || wall_text != "1" || power_text != "1" || structural_heat != "none")
    throw InputError("section Time: nothing changes in time here; choose Model = transient in the "
                     "section Temperature, or remove the amplitudes and the structural heat");
}

/// Times in s at which the amplitudes are looked at before the run.
template <int dim>
std::vector<double> Transient<dim>::samples() const
{
  constexpr unsigned int n = 100;
  std::vector<double> times;
  for (unsigned int k = 0; k <= n; ++k)
    times.push_back(final_time() * k / n);
  return times;
}

template <int dim>
void Transient<dim>::check_walls(const double theta_start) const
{
  std::set<double> walls;
  for (const auto& entry : conditions.heated())
    walls.insert(entry.second);
  for (const auto& entry : heat.ambient_temperatures())
    walls.insert(entry.second);
  for (const double wall : walls)
    for (const double time : samples()) {
      const double there = theta_start + (*wall_amplitude)(time) * (wall - theta_start);
      if (there < 1. || there > 1e4)
        throw InputError("section Time, entry 'Wall amplitude': it takes a wall of " +
                         as_text(wall) + " K to " + as_text(there) + " K at t = " + as_text(time) +
                         " s; temperatures are at least 1 K and at most 10000 K");
    }
}

template <int dim>
void Transient<dim>::setup(const System<dim>& deformation, const double target_voltage,
                           const double theta_start)
{
  if (!layout.is_transient())
    return;
  voltage = layout.has(Field::potential) ? target_voltage : 0.;
  theta = theta_start;
  system.setup(is_monolithic() ? Solved::all : Solved::temperature, deformation);
}

template <int dim>
void Transient<dim>::start()
{
  std::vector<double> kinks;
  for (const auto* amplitude : {&voltage_amplitude, &wall_amplitude, &power_amplitude})
    for (const auto& row : (*amplitude)->table())
      kinks.push_back(row.first);
  stepper.start(kinks);
  state.time = 0.;
  state.start();
}

template <int dim>
std::vector<double> Transient<dim>::times() const
{
  std::vector<double> result;
  for (const auto& accepted : state.path())
    result.push_back(accepted.load);
  return result;
}

template <int dim>
void Transient<dim>::prescribe(const double time)
{
  const double warming = (*wall_amplitude)(time);
  state.time = time;
  state.voltage = voltage_at(time);
  conditions.apply(state.voltage, theta, warming, state.x);
  heat.apply(theta, warming, (*power_amplitude)(time));
}

template <int dim>
NewtonReport Transient<dim>::step(Predictor<dim>& predictor, const Newton& newton,
                                  const Solve& solve_deformation)
{
  const double time = stepper.next();
  state.rates = backward_differences(time, times(), stepper.order());
  state.rates->heat = structural_heat == "power"     ? StructuralHeat::power
                      : structural_heat == "entropy" ? StructuralHeat::entropy
                                                     : StructuralHeat::none;
  predictor.predict(time, LoadSymmetry::none);
  prescribe(time);
  NewtonReport report = newton.solve(system);
  if (!report.converged || is_monolithic())
    return report;
  const std::vector<double> before = times();
  if (std::all_of(before.begin(), before.end(),
                  [&](const double t) { return voltage_at(t) == state.voltage; }))
    predictor.follow_temperature();
  NewtonReport deformed = solve_deformation();
  deformed.add(report);
  return deformed;
}

template <int dim>
bool Transient<dim>::accept()
{
  const std::size_t known = state.path().size();
  const unsigned int used = std::min<std::size_t>(stepper.order(), known - 1);
  if (!stepper.accept(used > 0 ? error(used) : 0., used)) {
    restore();
    return false;
  }
  state.accept(state.time);
  state.inflow = system.heat_inflow();
  return true;
}

/// Root mean square over the nodes of what the step did wrong, in K.
template <int dim>
double Transient<dim>::error(const unsigned int order) const
{
  const unsigned int block = layout.block(Field::temperature);
  const std::vector<double> known = times();
  auto difference = state.x.block(block);
  for (std::size_t k = known.size() - order - 1; k < known.size(); ++k) {
    double weight = 1.; // of the polynomial through the newest states
    for (std::size_t l = known.size() - order - 1; l < known.size(); ++l)
      if (l != k)
        weight *= (state.time - known[l]) / (known[k] - known[l]);
    difference.add(-weight, state.path()[k].x.block(block));
  }
  difference.zero_out_ghost_values();
  return error_share(state.time, known, order) * difference.l2_norm() /
         std::sqrt(static_cast<double>(difference.size()));
}

template <int dim>
void Transient<dim>::cut_back()
{
  restore();
  stepper.cut_back();
}

/// The newest accepted state with its own time and voltage, which fields and checkpoints tell.
template <int dim>
void Transient<dim>::restore()
{
  state.restore();
  state.time = state.accepted_load();
  state.voltage = voltage_at(state.time);
}

template <int dim>
std::vector<std::string> Transient<dim>::summary() const
{
  const double n = layout.n_dofs(Field::displacement) +
                   (layout.has(Field::potential) ? layout.n_dofs(Field::potential) : 0);
  const double n_theta = layout.n_dofs(Field::temperature);
  // Operations of a factorisation by nested dissection, twice as many if it is unsymmetric.
  const double power = dim == 2 ? 1.5 : 2.;
  const double ratio =
      2. * std::pow(n + n_theta, power) / (std::pow(n, power) + std::pow(n_theta, power));
  std::ostringstream text;
  text << std::setprecision(2) << "coupling: " << coupling
       << "; staggered is cheaper, because its two matrices are symmetric and smaller: one "
       << "monolithic factorisation costs about " << ratio << " times as much";
  return {"time: " + std::string(stepper.order() == 2 ? "BDF2" : "backward Euler") +
              ", structural heat: " + structural_heat,
          text.str()};
}

template class Transient<2>;
template class Transient<3>;

} // namespace thelma
