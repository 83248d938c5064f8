#pragma once

#include <thelma/elements/formulation.h>
#include <thelma/fields/state.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace thelma
{

/// The own cells with their element formulation, and what each of them needs to be evaluated at the
/// State's iterate.
template <int dim>
class CellLoop
{
public:
  CellLoop(const DofLayout<dim>& layout, State& state) : layout(layout), state(state) {}

  /// Choose the @p formulation for the @p fields to be solved; the fields must stand.
  void choose(const std::string& formulation, Solved fields);

  /// Give the state its internal unknowns, those of the stress-free body, and whatever the laws
  /// remember.
  void setup();
  void initialise_internal();

  Solved solved() const { return fields; }
  const Formulation<dim>& formulation() const { return *element; }

  /// The linear solver keeps the pressures of the cells as unknowns.
  void keep_pressures(const bool kept) { pressures_are_kept = kept; }

  /// The stabilisation of each cell in MPa; none: zero.
  const std::vector<double>& stabilisation() const { return stabilisations; }
  void stabilise(std::vector<double> values) { stabilisations = std::move(values); }

  /// Call @p visit with the CellView of each own cell.
  template <typename Visitor>
  void for_each(const Visitor& visit) const;

  /// What the laws of an own cell remember.
  CellMemory memory(std::size_t cell) const;

  /// What the step to the iterate has done wrong to internal variables, which are strains: root
  /// mean square over the points that have some.
  double memory_error() const;

  /// The table of a law that does not reach the temperature of a point of any rank, a sentence;
  /// empty if all do.
  std::string table_defect() const;

  /// What the own cells store in mJ, in plane strain per mm.
  Energies energies() const;

private:
  /// What the steps of all points belong to.
  struct StepKey {
    std::size_t version = 0;
    double time = 0.;
    bool flows = false;
    bool operator==(const StepKey& other) const
    {
      return version == other.version && time == other.time && flows == other.flows;
    }
  };

  void keep_memory();
  StepTimes step_times() const;
  void set_accepted(std::size_t first_point, CellMemory& memory) const;
  void prepare_steps() const;

  const DofLayout<dim>& layout;
  State& state;
  Solved fields = Solved::all;
  std::unique_ptr<Formulation<dim>> element;
  unsigned int n_remembered = 0, n_of_step = 0; ///< numbers at a point, by the law with most
  mutable StepKey prepared;
  mutable std::vector<double> steps; ///< of the points of all own cells
  bool pressures_are_kept = false;
  std::vector<double> stabilisations;
};

template <int dim>
template <typename Visitor>
void CellLoop<dim>::for_each(const Visitor& visit) const
{
  const std::size_t n_internal = element ? element->n_internal() : 0;
  const bool has_history =
      state.rates && state.rates->heat != StructuralHeat::none && fields != Solved::deformation;
  std::vector<double> x, past[2];
  CellHistory history;
  std::size_t index = 0;
  for (const Cell<dim>& cell : layout.cells()) {
    layout.gather(cell, state.x, x);
    CellView<dim> view{index,       cell,
                       x.data(),    state.internal.data() + index * n_internal,
                       state.theta, layout.has(Field::temperature),
                       fields};
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
    if (n_remembered > 0)
      view.memory = memory(index);
    view.keeps_pressures = pressures_are_kept;
    visit(view);
    ++index;
  }
}

} // namespace thelma
