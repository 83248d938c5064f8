#include <thelma/base/axes.h>
#include <thelma/base/option_names.h>
#include <thelma/base/parameters.h>
#include <thelma/output/curve.h>
#include <thelma/output/fields.h>
#include <thelma/output/vtu_files.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

namespace thelma
{
namespace
{

using dealii::DataComponentInterpretation::component_is_part_of_tensor;
using dealii::DataComponentInterpretation::component_is_part_of_vector;
using dealii::DataComponentInterpretation::component_is_scalar;

/// P, D, E and J at the points of the output, by the material's own functions and the pressure of
/// the element.
template <int dim>
class PointQuantities final : public dealii::DataPostprocessor<dim>
{
public:
  explicit PointQuantities(const ObservableInput<dim>& scene)
      : scene(scene),
        points(dealii::QTrapezoid<1>(), scene.layout.degree()) // as DataOut subdivides cells
  {
    for (std::size_t index = 0; index < scene.layout.cells().size(); ++index)
      index_of[scene.layout.cells()[index].iterator->active_cell_index()] = index;
    const std::vector<dealii::Point<dim>>& inner =
        scene.system.cells.formulation().law_points().get_points();
    for (const dealii::Point<dim>& point : points.get_points())
      nearest.push_back(std::min_element(inner.begin(), inner.end(),
                                         [&](const auto& a, const auto& b) {
                                           return a.distance(point) < b.distance(point);
                                         }) -
                        inner.begin());
  }

  std::vector<std::string> get_names() const override
  {
    std::vector<std::string> names(static_cast<std::size_t>(dim * dim), "P");
    names.insert(names.end(), dim, "D");
    names.insert(names.end(), dim, "E");
    names.emplace_back("J");
    if (scene.layout.is_axisymmetric())
      names.emplace_back("P22");
    return names;
  }

  std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>
  get_data_component_interpretation() const override
  {
    std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation> kinds(
        static_cast<std::size_t>(dim * dim), component_is_part_of_tensor);
    kinds.insert(kinds.end(), std::size_t(2) * dim, component_is_part_of_vector);
    kinds.resize(get_names().size(), component_is_scalar);
    return kinds;
  }

  dealii::UpdateFlags get_needed_update_flags() const override
  {
    return dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points;
  }

  void evaluate_vector_field(const dealii::DataPostprocessorInputs::Vector<dim>& input,
                             std::vector<dealii::Vector<double>>& output) const override
  {
    const auto& cell = input.template get_cell<dim>();
    const Material& material = scene.materials.of_region(scene.mesh.region_of(cell));
    const CellMemory memory = scene.system.cells.memory(index_of.at(cell->active_cell_index()));
    for (std::size_t q = 0; q < output.size(); ++q) {
      PointState<> state = point(input, q);
      state.history = memory.at(nearest[q]);
      const Kinematics<> kin(state.F);
      FirstDerivatives<> d;
      material.evaluate(state, d);
      Volumetric<> volumetric{};
      volumetric.p = pressure(cell->active_cell_index(), q, state);
      add_volumetric(kin, volumetric, d);
      for (int i = 0; i < dim; ++i) {
        for (int J = 0; J < dim; ++J)
          output[q][i * dim + J] = d.P[axis<dim>(i)][axis<dim>(J)];
        output[q][dim * dim + i] = d.D[axis<dim>(i)];
        output[q][dim * dim + dim + i] = state.E[axis<dim>(i)];
      }
      output[q][dim * dim + 2 * dim] = kin.J;
      if (scene.layout.is_axisymmetric())
        output[q][dim * dim + 2 * dim + 1] = d.P[1][1];
    }
  }

private:
  PointState<> point(const dealii::DataPostprocessorInputs::Vector<dim>& input,
                     const std::size_t q) const
  {
    PointState<> state;
    state.theta = scene.state.theta;
    for (int i = 0; i < 3; ++i)
      state.F[i][i] = 1.;
    for (int J = 0; J < dim; ++J)
      for (int i = 0; i < dim; ++i)
        state.F[axis<dim>(i)][axis<dim>(J)] += input.solution_gradients[q][i][J];
    if (scene.layout.is_axisymmetric())
      state.F[1][1] += stretch_around_axis(input, q);
    if (scene.layout.has(Field::potential))
      for (int J = 0; J < dim; ++J)
        state.E[axis<dim>(J)] =
            -input.solution_gradients[q][scene.layout[Field::potential].component][J];
    if (scene.layout.has(Field::temperature))
      state.theta = input.solution_values[q][scene.layout[Field::temperature].component];
    return state;
  }

  /// u_1/R, and its limit on the axis.
  double stretch_around_axis(const dealii::DataPostprocessorInputs::Vector<dim>& input,
                             const std::size_t q) const
  {
    const double R = input.evaluation_points[q][0];
    return R > 1e-9 * input.template get_cell<dim>()->diameter()
               ? input.solution_values[q][0] / R
               : input.solution_gradients[q][0][0];
  }

  double pressure(const unsigned int active_cell, const std::size_t q,
                  const PointState<>& state) const
  {
    const Formulation<dim>& element = scene.system.cells.formulation();
    const std::size_t index = index_of.at(active_cell);
    const CellView<dim> view{
        index,       scene.layout.cells()[index],
        nullptr,     scene.state.internal.data() + index * element.n_internal(),
        state.theta, scene.layout.has(Field::temperature)};
    return element.pressure(view, points.point(q), state);
  }

  const ObservableInput<dim>& scene;
  dealii::QIterated<dim> points;
  std::map<unsigned int, std::size_t> index_of; ///< active cell -> own cell
  std::vector<unsigned int> nearest; ///< of the points that remember, to each of the output
};

/// Names and kinds of the solution's own components.
template <int dim>
void describe(const DofLayout<dim>& layout, std::vector<std::string>& names,
              std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>& kinds)
{
  names.assign(dim, "u");
  kinds.assign(dim, component_is_part_of_vector);
  for (const Field field : layout.fields())
    if (field != Field::displacement) {
      names.emplace_back(field == Field::potential ? "phi" : "theta");
      kinds.push_back(component_is_scalar);
    }
}

} // namespace

template <int dim>
void FieldWriter<dim>::declare(dealii::ParameterHandler& prm)
{
  const Section section(prm, {"Output"});
  OptionNames<Frequency>(
      {{"every", Frequency::every}, {"last", Frequency::last}, {"none", Frequency::none}})
      .declare(prm, "Fields", frequency,
               "Accepted steps whose fields are written as VTU, one file per 16 ranks: `every`, "
               "`last` or `none`.");
}

template <int dim>
void FieldWriter<dim>::remove_old(const std::string& folder)
{
  const std::regex name("fields\\.pvd|(fields|mode)_\\d+(\\.\\d+)?\\.p?vtu");
  std::vector<std::string> old;
  for (const auto& file : std::filesystem::directory_iterator(folder))
    if (std::regex_match(file.path().filename().string(), name))
      old.push_back(file.path().string());
  for (const std::string& file : old)
    remove_file(file);
}

template <int dim>
void FieldWriter<dim>::write(const ObservableInput<dim>& scene, const std::string& folder,
                             const unsigned int step, const double load, const bool last)
{
  if (frequency == Frequency::none || (frequency == Frequency::every) == last)
    return;
  std::vector<std::string> names;
  std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation> kinds;
  describe(scene.layout, names, kinds);
  const PointQuantities<dim> quantities(scene);
  BlockVector x = scene.state.x;
  scene.layout.complete(x);
  VtuFiles<dim> out;
  out.add_data_vector(scene.layout.dof_handler(), x, names, kinds);
  out.add_data_vector(scene.layout.dof_handler(), x, quantities);
  out.build_patches(scene.layout.mapping(), scene.layout.degree(),
                    dealii::DataOut<dim>::curved_inner_cells);
  const std::string file = out.write(folder, "fields_" + dealii::Utilities::int_to_string(step, 4),
                                     scene.layout.communicator());

  if (!written.empty() && written.back().first == load)
    written.pop_back(); // on the way to the state at time 0
  written.emplace_back(load, file);
  write_list(scene.layout.communicator(), folder);
}

template <int dim>
void FieldWriter<dim>::write_list(const MPI_Comm comm, const std::string& folder) const
{
  if (written.empty())
    return;
  on_rank_0(comm, [&]() {
    std::ostringstream pvd;
    dealii::DataOutBase::write_pvd_record(pvd, written);
    write_file(folder + "/fields.pvd", pvd.str());
  });
}

template <int dim>
void FieldWriter<dim>::write_mode(const ObservableInput<dim>& scene, const std::string& folder,
                                  BlockVector mode)
{
  if (frequency == Frequency::none)
    return;
  std::vector<std::string> names;
  std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation> kinds;
  describe(scene.layout, names, kinds);
  mode.update_ghost_values();
  scene.layout.complete(mode);
  VtuFiles<dim> out;
  out.add_data_vector(scene.layout.dof_handler(), mode, names, kinds);
  out.build_patches(scene.layout.mapping(), scene.layout.degree(),
                    dealii::DataOut<dim>::curved_inner_cells);
  out.write(folder, "mode_" + std::to_string(n_modes++), scene.layout.communicator());
}

template class FieldWriter<2>;
template class FieldWriter<3>;

} // namespace thelma
