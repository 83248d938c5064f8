#pragma once

#include <thelma/assembly/floating_electrodes.h>
#include <thelma/assembly/heat_storage.h>
#include <thelma/assembly/p1_coarse_spaces.h>
#include <thelma/assembly/pressure_blocks.h>
#include <thelma/assembly/tangent_matrix.h>
#include <thelma/base/timings.h>
#include <thelma/elements/formulation.h>
#include <thelma/fields/state.h>
#include <thelma/loads/loads.h>
#include <thelma/solvers/continuation.h>

#include <map>
#include <memory>
#include <string>

namespace thelma
{

/// The discrete balance of a scene: sums the cells into residual and tangent at the State's
/// iterate and solves for corrections.
template <int dim>
class System : public LoadedSystem
{
public:
  System(const DofLayout<dim>& layout, const BoundaryConditions<dim>& conditions,
         const Loads<dim>& loads, const HeatStorage<dim>& storage, State& state, Timings& timings);

  void declare(dealii::ParameterHandler& prm);

  /// Choose formulation and linear solver for the fields to be solved; the fields must stand.
  /// Throws InputError where they do not fit.
  void choose(Solved fields = Solved::all);

  /// Build the matrix for what has been chosen; the constraints must stand.
  void setup();

  /// The same for other fields than those of @p other.
  void choose(Solved fields, const System& other);

  /// Set the internal unknowns to those of the stress-free body at the uniform temperature.
  void start_internal();

  void begin() override;
  bool follow() override;
  ResidualReport residual() override;
  LinearReport linear_solve(bool reuse) override;
  void move_to(double step) override;
  double rounding() override;

  /// From now on the load factor leads along this path, which must live as long as it does.
  void load_along(LoadPath* loads_of_path) { path = loads_of_path; }
  LoadPath* load_path() const { return path; }
  double load() const override { return load_factor; }
  void set_load(double load) override;
  LinearReport solve_load() override;
  void add_response(double change) override;
  const Displacement& displacement() const override { return state.x.block(0); }
  const Displacement& correction() const override { return nodal_correction.block(0); }
  const Displacement& response() const override { return nodal_response.block(0); }

  /// The eigenvalue of smallest size of the tangent last factorised with all fields but the
  /// displacement eliminated, and its eigenvector of length 1 in @p mode (theory.md, eq. 52); not a
  /// number where it is not found.
  double critical_mode(BlockVector& mode);

  /// Assemble the tangent at the iterate.
  void assemble_tangent();
  const dealii::TrilinosWrappers::BlockSparseMatrix& tangent() const { return matrix.matrix(); }

  /// Residual before constraints: at prescribed unknowns the reactions (N; minus the charge in
  /// uC at electrodes).
  const BlockVector& reactions() const { return raw_residual; }
  BlockVector free_residual() const;

  /// Hold the body with these nodal forces, charges and heat flows (N, minus uC, mW), beside its
  /// loads.
  void hold_with(const BlockVector& forces) { holding = forces; }

  /// What enters through the walls, all of them, at the newest residual.
  HeatInflow heat_inflow() const;

  /// Call @p visit for each own cell at the current iterate.
  template <typename Visitor>
  void for_each_cell(const Visitor& visit) const;

  /// What the laws of an own cell remember.
  CellMemory memory(std::size_t cell) const;

  /// Solve the cells' internal equations at the current nodal values; the tangent stays.
  void relax_internal();

  /// The element formulation, once set up.
  const Formulation<dim>& element() const { return *formulation; }

  /// What the own cells store in mJ, in plane strain per mm.
  Energies energies() const;

  /// Whether @p field is among what it solves for.
  bool solves(const Field field) const
  {
    return solved == Solved::all ||
           (field == Field::temperature) == (solved == Solved::temperature);
  }

  bool is_symmetric() const { return !layout.has(Field::temperature) || solved != Solved::all; }

  /// From now on the unstable directions that this unsymmetric tangent does not tell are counted on
  /// that of @p displacement_and_potential (theory.md, eqs. 48, 49).
  void count_on(System& displacement_and_potential)
  {
    symmetric_part = &displacement_and_potential;
  }

  /// Whether it is known in how many directions a state is unstable: not for a tangent that is not
  /// factorised, nor before the solver is chosen.
  bool knows_stability() const;

  /// The negative pivots of the symmetric tangent that tells of stability at the iterate, where the
  /// tangent last factorised has @p own.
  LinearReport count_pivots(long long own);

  /// By these negative pivots beyond those of a stable state's tangent.
  long long unstable_directions(long long negative_pivots) const;

  /// Whether linear solves take iterations.
  bool iterates() const { return solver && solver->iterates(); }

  /// Whether factors would be too large.
  bool uses_multigrid() const { return solver->uses_multigrid(); }

  /// Of cells and of the tangent's entries: the largest share of a rank over the mean.
  std::map<std::string, double> imbalance() const;

  /// The most unknowns that a rank needs of others, over the mean of its own.
  double halo() const;

  /// Which linear solver serves, and why.
  std::string solver_description() const;

  /// Unstable directions must be counted for @p entry of the scene.
  void require_inertia(const std::string& entry) { counts_for = entry; }

private:
  /// Residual with the internal unknowns eliminated, in @p nodal.
  void eliminate_internal(BlockVector& nodal) const;

  /// Correction of the internal unknowns that belongs to the nodal one, @p dx.
  void recover_internal(BlockVector& dx, std::vector<double>& values) const;

  double orientation(BlockVector& mode) const;
  BlockVector last_digits() const;
  void include_charges(ResidualReport& report) const;

  /// Replace minus a nodal residual by the correction that belongs to it; the charges of floating
  /// electrodes lack @p charges.
  LinearReport solve_tangent(BlockVector& vector, const std::vector<double>& charges);
  void keep_memory();
  void choose_solver();
  void keep_pressures();
  LinearReport prepare_solver();
  Elimination<dim> elimination(std::size_t cell) const;
  void keep_elimination(std::size_t cell, const CellResult& result);

  /// Norms of the nodal forces that a unit stress mu (displacement sqrt(eps mu), heat flux
  /// k * 1 K/mm) exerts: the units of each field's residual.
  void compute_scales();
  double scale(unsigned int block) const;

  std::vector<double> needed_stabilisations() const;

  /// Zero what belongs to given unknowns.
  void clear_given(BlockVector& x) const;

  const DofLayout<dim>& layout;
  const BoundaryConditions<dim>& conditions;
  const Loads<dim>& loads;
  const HeatStorage<dim>& storage;
  State& state;
  Timings& timings;
  Solved solved = Solved::all;

  std::string formulation_name = "selective reduced";
  std::unique_ptr<Formulation<dim>> formulation;
  unsigned int n_history = 0; ///< numbers remembered at a point, by the law with most of the scene
  TangentMatrix<dim> matrix;
  FloatingElectrodes<dim> floating;
  std::vector<double> charge_scales; ///< of all electrodes
  LinearSettings linear_settings;
  LinearChoice choice;
  std::string counts_for; ///< entry that needs unstable directions
  System* symmetric_part = nullptr;
  std::unique_ptr<PressureBlocks<dim>> pressures; ///< of a solver that keeps them
  std::unique_ptr<P1CoarseSpaces<dim>> corner_grids;
  std::unique_ptr<LinearSolver> solver; ///< refers to both
  std::vector<double> scales;           ///< per block
  double volume = 0.;                   ///< mm^dim
  double tangent_cost = 1.;             ///< of the last one, LinearReport::cost
  int unstable_inside = 0;              ///< directions in all cells, at the last tangent
  BlockVector raw_residual, holding, base, nodal_correction, nodal_response;
  std::vector<double> internal_base, internal_correction, internal_response;
  std::vector<double> internal_residual; ///< of all own cells
  std::vector<double> stabilisations;    ///< of all own cells, MPa
  std::vector<double> lacking;           ///< of them, when they last followed the state
  double relaxation = 1.;                ///< part of it that was added
  std::vector<double> eliminations;      ///< of all own cells, of the tangent last assembled
  LoadPath* path = nullptr;
  double load_factor = 0.;
};

template <int dim>
template <typename Visitor>
void System<dim>::for_each_cell(const Visitor& visit) const
{
  const std::size_t n_internal = formulation ? formulation->n_internal() : 0;
  const bool has_history =
      state.rates && state.rates->heat != StructuralHeat::none && solved != Solved::deformation;
  std::vector<double> x, past[2];
  CellHistory history;
  std::size_t index = 0;
  for (const Cell<dim>& cell : layout.cells()) {
    layout.gather(cell, state.x, x);
    CellView<dim> view{index,       cell,
                       x.data(),    state.internal.data() + index * n_internal,
                       state.theta, layout.has(Field::temperature),
                       solved};
    if (!stabilisations.empty())
      view.stabilisation = stabilisations[index];
    if (has_history) {
      history.rates = *state.rates;
      for (std::size_t k = 0; k < history.rates.n_past; ++k) {
        const State::Accepted& accepted = state.path()[state.path().size() - 1 - k];
        layout.gather(cell, accepted.x, past[k]);
        history.x[k] = past[k].data();
        history.internal[k] = accepted.internal.data() + index * n_internal;
      }
      view.history = &history;
    }
    if (n_history > 0)
      view.memory = memory(index);
    view.keeps_pressures = pressures != nullptr;
    visit(view);
    ++index;
  }
}

} // namespace thelma
