// Which linear solver serves, and what it needs to know of the tangent.

#include <thelma/assembly/system.h>

#include <deal.II/base/mpi.h>

namespace thelma
{

template <int dim>
void System<dim>::choose_solver()
{
  unsigned long long unknowns = 0;
  for (const Field field : layout.fields())
    unknowns += layout.n_dofs(field);
  choice = choose_linear_solver(
      linear_settings,
      {dim, unknowns, formulation->n_kept_pressures() > 0 && is_symmetric(), needs_inertia});
  if (solved == Solved::temperature)
    choice = {"direct", "the temperature alone is small"};
  solver = linear_solvers().create(choice.solver);
  solver->setup(layout.communicator(), is_symmetric(), linear_settings);
}

template <int dim>
void System<dim>::keep_pressures()
{
  pressures.reset();
  low_order.reset();
  if (!solver->keeps_pressures())
    return;
  pressures = std::make_unique<PressureBlocks<dim>>(
      layout, conditions, *formulation,
      [this](const std::size_t cell) { return elimination(cell); });
  low_order = std::make_unique<LowOrder<dim>>(layout, conditions, state);
}

template <int dim>
LinearReport System<dim>::prepare_solver()
{
  std::vector<bool> is_solved;
  for (const Field field : layout.fields())
    is_solved.push_back(solved == Solved::all ||
                        (field == Field::temperature) == (solved == Solved::temperature));
  if (pressures)
    pressures->update([this](const std::size_t cell) {
      return layout.cells()[cell].material->shear_modulus(state.theta);
    });
  LinearReport report =
      solver->prepare({matrix.matrix(), pressures.get(), low_order.get(), is_solved});
  if (report.solved) {
    floating.finish(*solver);
    report.negative_pivots += floating.negative_pivots();
  }
  return report;
}

template <int dim>
std::string System<dim>::solver_description() const
{
  return "linear solver: " + choice.solver + ", because " + choice.reason +
         (solver->has_inertia() ? "" : "; whether a state is stable remains unknown");
}

template void System<2>::choose_solver();
template void System<3>::choose_solver();
template void System<2>::keep_pressures();
template void System<3>::keep_pressures();
template LinearReport System<2>::prepare_solver();
template LinearReport System<3>::prepare_solver();
template std::string System<2>::solver_description() const;
template std::string System<3>::solver_description() const;

} // namespace thelma
