#include <thelma/base/axes.h>
#include <thelma/elements/contractions.h>
#include <thelma/output/end_of_path.h>
#include <thelma/output/points.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace thelma
{
namespace
{

/// Of the cells whose amplitudes are the largest, the one nearest to the origin on an oblique
/// plane: the same on any number of ranks.
template <int dim>
dealii::Point<dim> place_of_largest(const DofLayout<dim>& layout,
                                    const std::vector<double>& amplitudes)
{
  constexpr double as_large = 1. - 1e-4, oblique[3] = {1., 0.4, 0.7};
  const MPI_Comm comm = layout.communicator();
  const double largest = dealii::Utilities::MPI::max(
      amplitudes.empty() ? 0. : *std::max_element(amplitudes.begin(), amplitudes.end()), comm);
  double own = std::numeric_limits<double>::max();
  dealii::Point<dim> place;
  for (std::size_t k = 0; k < amplitudes.size(); ++k) {
    if (amplitudes[k] < as_large * largest)
      continue;
    const dealii::Point<dim> centre = layout.cells()[k].iterator->center();
    double distance = 0.;
    for (int d = 0; d < dim; ++d)
      distance += oblique[axis<dim>(d)] * centre[d];
    if (distance < own) {
      own = distance;
      place = centre;
    }
  }
  const double nearest = dealii::Utilities::MPI::min(own, comm);
  for (int d = 0; d < dim; ++d)
    place[d] = dealii::Utilities::MPI::max(
        own == nearest ? place[d] : std::numeric_limits<double>::lowest(), comm);
  return place;
}

} // namespace

template <int dim>
std::string describe_mode(const DofLayout<dim>& layout, BlockVector& mode)
{
  std::vector<double> amplitudes, values, own(dim, 0.), components(dim);
  mode.update_ghost_values();
  for (const Cell<dim>& cell : layout.cells()) {
    layout.gather(cell, mode, values);
    amplitudes.push_back(0.);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (const unsigned int c = i % cell.n_components; cell.field_of(c) == Field::displacement) {
        amplitudes.back() += values[i] * values[i];
        own[c] += values[i] * values[i];
      }
  }
  mode.zero_out_ghost_values();
  dealii::Utilities::MPI::sum(own, layout.communicator(), components);
  const auto main = std::max_element(components.begin(), components.end()) - components.begin();
  const dealii::Point<dim> place = place_of_largest(layout, amplitudes);
  std::ostringstream text;
  text.precision(3);
  text << "mostly u" << axis<dim>(main) + 1 << ", largest near";
  for (int d = 0; d < dim; ++d)
    text << (d > 0 ? ", " : " ") << 'x' << axis<dim>(d) + 1 << " = " << place[d];
  text << " mm";
  return text.str();
}

template <int dim>
double part_within_cells(const DofLayout<dim>& layout, BlockVector& mode)
{
  const Integration<dim> rule(layout, layout.degree() + 1);
  std::vector<double> values, own(2, 0.), squares(2); // of the gradient, of its means
  mode.update_ghost_values();
  for (std::size_t index = 0; index < layout.cells().size(); ++index) {
    const Cell<dim>& cell = layout.cells()[index];
    layout.gather(cell, mode, values);
    const NodalValues<dim> nodal(values.data(), rule.basis().n_nodes, cell.n_components);
    dealii::Tensor<2, dim> mean;
    double volume = 0.;
    for (unsigned int q = 0; q < rule.basis().n_points; ++q) {
      const PointGeometry<dim>& point = rule.of_cell(index)[q];
      const auto gradient = nodal.gradient(Gradients<dim>(rule.basis(), q, point));
      volume += point.JxW;
      for (int J = 0; J < dim; ++J)
        for (int i = 0; i < dim; ++i) {
          mean[i][J] += point.JxW * gradient[J][i];
          own[0] += point.JxW * gradient[J][i] * gradient[J][i];
        }
    }
    own[1] += mean.norm_square() / volume;
  }
  mode.zero_out_ghost_values();
  dealii::Utilities::MPI::sum(own, layout.communicator(), squares);
  return squares[0] > 0. ? 1. - squares[1] / squares[0] : 0.;
}

template <int dim>
std::string describe_field(const ObservableInput<dim>& scene)
{
  constexpr double weak = 1e-2; // against the largest nominal field
  Points<dim> points;
  points.setup(scene);
  const MPI_Comm comm = scene.layout.communicator();
  double nominal = 0., largest = 0., thinnest = std::numeric_limits<double>::max();
  points.visit(scene, [&](const PointState<>& state, const Material&, double) {
    nominal = std::max(nominal, state.E.norm());
  });
  nominal = dealii::Utilities::MPI::max(nominal, comm);
  if (!(nominal > 0.))
    return "";
  points.visit(scene, [&](const PointState<>& state, const Material& material, double) {
    if (state.E.norm() < weak * nominal)
      return;
    const double field = (Kinematics<>(state.F).G * state.E).norm();
    largest = std::max(largest, field * std::sqrt(material.permittivity(state.theta) /
                                                  material.shear_modulus(state.theta)));
    thinnest = std::min(thinnest, state.E.norm() / field);
  });
  std::ostringstream text;
  text.precision(4);
  text << "largest true field e_true = " << dealii::Utilities::MPI::max(largest, comm)
       << ", smallest stretch along the field " << dealii::Utilities::MPI::min(thinnest, comm);
  return text.str();
}

template std::string describe_mode(const DofLayout<2>&, BlockVector&);
template std::string describe_mode(const DofLayout<3>&, BlockVector&);
template double part_within_cells(const DofLayout<2>&, BlockVector&);
template double part_within_cells(const DofLayout<3>&, BlockVector&);
template std::string describe_field(const ObservableInput<2>&);
template std::string describe_field(const ObservableInput<3>&);

} // namespace thelma
