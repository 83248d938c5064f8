#include <thelma/base/complaints.h>
#include <thelma/base/option_names.h>
#include <thelma/base/parameters.h>
#include <thelma/transient.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

namespace thelma
{
namespace
{

OptionNames<StructuralHeat> structural_heats()
{
  return {{{"none", StructuralHeat::none},
           {"power", StructuralHeat::power},
           {"entropy", StructuralHeat::entropy}}};
}

} // namespace

template <int dim>
void Transient<dim>::declare(dealii::ParameterHandler& prm)
{
  using namespace dealii::Patterns;
  stepper.declare(prm);
  const Section section(prm, {"Time"});
  OptionNames<Coupling>({{"staggered", Coupling::staggered}, {"monolithic", Coupling::monolithic}})
      .declare(prm, "Coupling", coupling,
               "`staggered`: temperature, then displacement and potential, two symmetric "
               "systems; `monolithic`: all at once, one unsymmetric system.");
  structural_heats().declare(
      prm, "Structural heat", structural_heat,
      "Heat made by deformation and field: `none`; `power`: H beside the "
      "constant capacity c, as in the paper; `entropy`: theta times the rate "
      "of entropy, which conserves energy.");
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
      if (!layout.is_transient())
        return;
      const AmplitudeTimes found = entry.amplitude->times(final_time());
      kinks.insert(kinks.end(), found.kinks.begin(), found.kinks.end());
      bends.insert(bends.end(), found.bends.begin(), found.bends.end());
    });
  complaints.raise();
  if (layout.is_transient())
    return;
  if (voltage_text != "1" || wall_text != "1" || power_text != "1" ||
      structural_heat != StructuralHeat::none)
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
void Transient<dim>::choose(System<dim>& deformation)
{
  system.choose(is_monolithic() ? Solved::all : Solved::temperature, deformation);
  if (is_monolithic())
    system.count_on(deformation);
}

template <int dim>
void Transient<dim>::setup(const System<dim>& deformation, const double target_voltage,
                           const double theta_start)
{
  if (!layout.is_transient())
    return;
  voltage = layout.has(Field::potential) ? target_voltage : 0.;
  theta = theta_start;
  system.setup(deformation);
}

template <int dim>
void Transient<dim>::start()
{
  stepper.start(kinks, bends);
  longer.reset();
  wall_parts = 1;
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
void Transient<dim>::prescribe(const double time, const double part)
{
  const double before = warming(), warmed = before + part * ((*wall_amplitude)(time)-before);
  state.time = time;
  state.voltage = voltage_at(time);
  conditions.apply(state.voltage, theta, warmed, state.x);
  heat.apply(theta, warmed, (*power_amplitude)(time));
}

template <int dim>
NewtonReport Transient<dim>::step(Predictor<dim>& predictor, const Newton& newton,
                                  const Solve& solve_deformation)
{
  const double time = stepper.next();
  state.rates = backward_differences(time, times(), stepper.order());
  state.rates->heat = structural_heat;
  predictor.predict(time, LoadSymmetry::none);
  NewtonReport report;
  for (unsigned int n = 1; n <= wall_parts; ++n) {
    prescribe(time, static_cast<double>(n) / wall_parts);
    NewtonReport next = newton.solve(system);
    next.add(report);
    if (next.converged && n == wall_parts)
      step_error = find_error();
    const bool deforms = !is_monolithic() && (n < wall_parts || stepper.tolerates(step_error));
    report = next.converged && deforms ? deform(predictor, solve_deformation, next, n == 1) : next;
    if (!report.converged)
      break;
  }
  return report;
}

/// Solve for the deformation once the temperature is known, after the effort of @p warmed.
template <int dim>
NewtonReport Transient<dim>::deform(Predictor<dim>& predictor, const Solve& solve_deformation,
                                    const NewtonReport& warmed, const bool extrapolates)
{
  const std::vector<double> before = times();
  if (extrapolates && std::all_of(before.begin(), before.end(),
                                  [&](const double t) { return voltage_at(t) == state.voltage; }))
    predictor.follow_temperature();
  NewtonReport deformed = solve_deformation();
  deformed.add(warmed);
  return deformed;
}

template <int dim>
bool Transient<dim>::accept()
{
  if (!stepper.accept(step_error)) {
    if (state.path().size() == 1)
      longer = {state.time, state.x, {}};
    restore();
    return false;
  }
  wall_parts = 1;
  state.inflow = system.heat_inflow();
  state.accept(state.time);
  return true;
}

/// Root mean square over the nodes of the distance (K) of the temperature at one moment from the
/// polynomial through others; nothing where it is prescribed, as at walls that jump.
template <int dim>
double Transient<dim>::distance(const Moment& moment, const std::vector<Moment>& others) const
{
  BlockVector difference = *moment.x;
  for (const Moment& a : others) {
    double weight = 1.;
    for (const Moment& b : others)
      if (b.time != a.time)
        weight *= (moment.time - b.time) / (a.time - b.time);
    difference.add(-weight, *a.x);
  }
  difference.zero_out_ghost_values();
  conditions.constraints().set_zero(difference);
  const auto& theta = difference.block(layout.block(Field::temperature));
  return theta.l2_norm() / std::sqrt(static_cast<double>(theta.size()));
}

/// Unknown for a first step before there is a longer one to compare it with.
template <int dim>
std::optional<StepError> Transient<dim>::find_error() const
{
  const auto& path = state.path();
  const Moment now = {state.time, &state.x};
  if (path.size() == 1 && !longer)
    return {};
  if (path.size() == 1)
    return StepError{first_error_share(state.time, longer->load) *
                         distance({longer->load, &longer->x}, {{0., &path[0].x}, now}),
                     1};
  const unsigned int order = std::min<std::size_t>(stepper.order(), path.size() - 1);
  std::vector<Moment> newest;
  for (std::size_t k = path.size() - order - 1; k < path.size(); ++k)
    newest.push_back({path[k].load, &path[k].x});
  return StepError{error_share(state.time, times(), order) * distance(now, newest), order};
}

template <int dim>
void Transient<dim>::cut_back()
{
  restore();
  stepper.cut_back();
  constexpr unsigned int most = 16;
  if (wall_jumps())
    wall_parts = std::min(2 * wall_parts, most);
}

/// Part of their way that the walls have come in the last accepted state.
template <int dim>
double Transient<dim>::warming() const
{
  return state.path().size() == 1 ? 0. : (*wall_amplitude)(state.accepted_load());
}

/// Whether walls change however short the next step.
template <int dim>
bool Transient<dim>::wall_jumps() const
{
  constexpr double instant = 1e-9, smooth = 1e-6;
  const double soon = state.accepted_load() + instant * final_time();
  return std::abs((*wall_amplitude)(soon)-warming()) > smooth;
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
  text << std::setprecision(2) << "coupling: " << (is_monolithic() ? "monolithic" : "staggered")
       << "; staggered is cheaper, because its two matrices are symmetric and smaller: one "
       << "monolithic factorisation costs about " << ratio << " times as much";
  std::vector<std::string> lines{
      "time: " + std::string(stepper.order() == 2 ? "BDF2" : "backward Euler") +
          ", structural heat: " + structural_heats().name(structural_heat),
      text.str()};
  if (const std::string sentence = stepper.steps_over(bends); !sentence.empty())
    lines.push_back(sentence);
  return lines;
}

template class Transient<2>;
template class Transient<3>;

} // namespace thelma
