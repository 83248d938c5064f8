#include <thelma/assembly/system.h>
#include <thelma/base/parameters.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace thelma
{
namespace
{

/// Also of what is no number, at which l2_norm() ends a Debug build.
double norm(const BlockVector::BlockType& x)
{
  double sum = 0.;
  for (const double value : x)
    sum += value * value;
  return std::sqrt(dealii::Utilities::MPI::sum(sum, x.get_mpi_communicator()));
}

} // namespace

template <int dim>
System<dim>::System(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
                    const Loads<dim>& loads, const HeatStorage<dim>& storage, State& state,
                    Timings& timings)
    : layout(layout), conditions(conditions), loads(loads), storage(storage), state(state),
      timings(timings), floating(layout, conditions)
{
}

template <int dim>
void System<dim>::declare(dealii::ParameterHandler& prm)
{
  linear_settings.declare(prm);
  std::string names;
  for (const std::string& name : formulations<dim>().names())
    names += (names.empty() ? "" : "|") + name;
  const Section section(prm, {"Discretisation"});
  prm.add_parameter("Formulation", formulation_name,
                    "Element formulation: how the nearly incompressible volumetric energy is "
                    "integrated.",
                    dealii::Patterns::Selection(names));
}

template <int dim>
void System<dim>::choose(const Solved fields)
{
  solved = fields;
  const auto timer = timings.measure("setup");
  formulation = formulations<dim>().create(formulation_name);
  formulation->setup(layout);
  choose_solver();
}

template <int dim>
void System<dim>::setup()
{
  const auto timer = timings.measure("setup");
  matrix.setup(layout, conditions,
               [this](const Cell<dim>& cell, const unsigned int c, const unsigned int d) {
                 return solves(cell.field_of(c)) && solves(cell.field_of(d));
               });
  floating.setup(solved != Solved::temperature);
  state.internal.resize(layout.cells().size() * formulation->n_internal());
  start_internal();
  internal_residual.assign(state.internal.size(), 0.);
  eliminations.assign(layout.cells().size() * formulation->n_elimination(), 0.);
  raw_residual = layout.new_vector();
  base = nodal_correction = nodal_response = holding = layout.new_vector();
  internal_base = internal_correction = internal_response = state.internal;
  state.x.update_ghost_values();
  keep_memory();
  compute_scales();
  keep_pressures();
}

template <int dim>
void System<dim>::choose(const Solved fields, const System& other)
{
  formulation_name = other.formulation_name;
  linear_settings = other.linear_settings;
  counts_for = other.counts_for;
  choose(fields);
}

template <int dim>
void System<dim>::compute_scales()
{
  const Integration<dim> rule(layout, layout.degree() + 1);
  BlockVector forces = layout.new_vector();
  volume = 0.;
  for_each_cell([&](const CellView<dim>& view) {
    const Material& material = *view.cell.material;
    const auto units = flux_units(material, state.theta);
    const int n_c = view.cell.n_components;
    for (unsigned int q = 0; q < rule.basis().n_points; ++q) {
      const auto& point = rule.of_cell(view.index)[q];
      volume += point.JxW;
      for (unsigned int a = 0; a < rule.basis().n_nodes; ++a) {
        dealii::Tensor<1, dim> reference;
        for (int K = 0; K < dim; ++K)
          reference[K] = rule.basis().dN[(q * dim + K) * rule.basis().stride + a];
        const double size =
            point.JxW * (dealii::transpose(point.inverse_jacobian) * reference).norm();
        for (int c = 0; c < n_c; ++c)
          forces(view.cell.dofs[a * n_c + c]) +=
              size * units[static_cast<std::size_t>(view.cell.field_of(c))];
      }
    }
  });
  volume = dealii::Utilities::MPI::sum(volume, layout.communicator());
  forces.compress(dealii::VectorOperation::add);
  charge_scales.clear();
  for (const Electrode& electrode : conditions.electrodes())
    charge_scales.push_back(
        dealii::Utilities::MPI::sum(electrode.own_sum(forces), layout.communicator()));
  conditions.constraints().set_zero(forces);
  scales.clear();
  for (unsigned int b = 0; b < forces.n_blocks(); ++b)
    scales.push_back(forces.block(b).l2_norm());
}

template <int dim>
ResidualReport System<dim>::residual()
{
  const auto timer = timings.measure("residual");
  CellResult result;
  double min_det_F = std::numeric_limits<double>::max(), internal_error = 0.;
  raw_residual = 0.;
  for_each_cell([&](const CellView<dim>& view) {
    formulation->residual(view, result);
    min_det_F = std::min(min_det_F, result.min_det_F);
    internal_error += result.internal_error;
    std::copy(result.internal.begin(), result.internal.end(),
              internal_residual.begin() + view.index * formulation->n_internal());
    layout.scatter(view.cell, result.residual, raw_residual);
  });
  loads.add_forces(
      -1., state, state.x, [this](const Field field) { return solves(field); }, raw_residual);
  raw_residual.compress(dealii::VectorOperation::add);
  if (solved != Solved::deformation)
    storage.add_residual(state, raw_residual);
  raw_residual -= holding;
  clear_given(raw_residual);

  ResidualReport report{0., dealii::Utilities::MPI::min(min_det_F, layout.communicator())};
  // Pressures answer to a temperature, which does not answer to them.
  if (solved != Solved::temperature)
    report.include(
        std::sqrt(dealii::Utilities::MPI::sum(internal_error, layout.communicator()) / volume));
  const BlockVector residual = free_residual();
  for (unsigned int b = 0; b < residual.n_blocks(); ++b)
    report.include(norm(residual.block(b)) / scale(b));
  include_charges(report);
  return report;
}

template <int dim>
BlockVector System<dim>::free_residual() const
{
  BlockVector residual = raw_residual;
  residual.zero_out_ghost_values();
  conditions.constraints().set_zero(residual);
  return residual;
}

template <int dim>
void System<dim>::assemble_tangent()
{
  const auto timer = timings.measure("tangent");
  CellResult result;
  matrix.clear();
  floating.clear();
  int unstable = 0;
  for_each_cell([&](const CellView<dim>& view) {
    formulation->tangent(view, result);
    matrix.add(view.index, view.cell, result.tangent);
    floating.add(view.index, view.cell, result.tangent);
    unstable += result.unstable_inside;
    keep_elimination(view.index, result);
  });
  loads.add_tangent(
      state, [this](const Field field) { return solves(field); }, matrix);
  matrix.finish();
  if (solved != Solved::deformation)
    storage.add_tangent(state, matrix);
  unstable_inside = dealii::Utilities::MPI::sum(unstable, layout.communicator());
}

template <int dim>
LinearReport System<dim>::linear_solve(const bool reuse)
{
  base = state.x;
  internal_base = state.internal;
  LinearReport report{true, "", false, 0, tangent_cost};
  if (!reuse || !floating.is_current()) {
    assemble_tangent();
    const auto timer = timings.measure("factorisation");
    report = prepare_solver();
    if (!report.solved)
      return report;
    tangent_cost = report.cost;
  }
  const auto timer = timings.measure("linear solve");
  nodal_correction.zero_out_ghost_values();
  nodal_correction = raw_residual;
  eliminate_internal(nodal_correction);
  nodal_correction *= -1.;
  const LinearReport solution = solve_tangent(nodal_correction, floating.charges(state.charge));
  recover_internal(nodal_correction, internal_correction);
  report.solved = solution.solved;
  report.reason = solution.reason;
  report.iterations += solution.iterations;
  return report;
}

template <int dim>
LinearReport System<dim>::solve_tangent(BlockVector& vector, const std::vector<double>& charges)
{
  std::vector<double> lacking = floating.sums(vector);
  for (std::size_t k = 0; k < lacking.size(); ++k)
    lacking[k] -= charges[k];
  conditions.constraints().set_zero(vector);
  clear_given(vector);
  LinearReport report = solver->solve(vector);
  conditions.constraints().set_zero(vector);
  floating.correct(lacking, vector);
  return report;
}

/// Errors of the charges of floating electrodes in units of the scaled residual.
template <int dim>
void System<dim>::include_charges(ResidualReport& report) const
{
  const std::vector<double> charges = floating.charges(state.charge),
                            reactions = floating.sums(raw_residual);
  std::size_t e = 0;
  for (std::size_t k = 0; k < charges.size(); ++k, ++e) {
    while (!conditions.electrodes()[e].floats)
      ++e;
    report.include(std::abs(reactions[k] + charges[k]) / charge_scales[e]);
  }
}

template <int dim>
void System<dim>::move_to(const double step)
{
  state.x = base;
  state.x.add(step, nodal_correction);
  state.x.update_ghost_values();
  for (std::size_t i = 0; i < state.internal.size(); ++i)
    state.internal[i] = internal_base[i] + step * internal_correction[i];
}

template class System<2>;
template class System<3>;

} // namespace thelma
