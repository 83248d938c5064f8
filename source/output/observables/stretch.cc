#include <thelma/base/axes.h>
#include <thelma/base/error.h>
#include <thelma/base/parameters.h>
#include <thelma/output/observables/observables.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <optional>

namespace thelma
{
namespace
{

/// Mean of one displacement component and of the position over a named surface.
template <int dim>
struct SurfaceMean {
  void setup(const ObservableInput<dim>& scene, const std::string& surface,
             const std::string& place, const unsigned int component)
  {
    const auto& scalar = scene.layout.scalar_element();
    dealii::FEFaceValues<dim> values(
        scene.layout.mapping(), scalar, dealii::QGauss<dim - 1>(scalar.degree + 1),
        dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points);
    std::vector<dealii::types::global_dof_index> dofs;
    double area = 0., moment = 0.;
    bool has_other = false;
    for (const auto& entity : scene.mesh.surface(surface, place)) {
      const std::optional<unsigned int> face = face_of(entity.vertices);
      if (!face) {
        has_other = true;
        continue;
      }
      values.reinit(entity.cell, *face);
      const auto cell = scene.layout.with_unknowns(entity.cell);
      scene.layout.unknowns(cell, dofs);
      for (const unsigned int q : values.quadrature_point_indices()) {
        const double share = scene.layout.depth(values.quadrature_point(q)) * values.JxW(q);
        area += share;
        moment += share * values.quadrature_point(q)[component];
        for (unsigned int a = 0; a < scalar.dofs_per_cell; ++a)
          weights.emplace_back(dofs[*scene.layout.local_dof(cell->active_fe_index(), a, component)],
                               values.shape_value(a, q) * share);
      }
    }
    comm = scene.layout.communicator();
    if (dealii::Utilities::MPI::logical_or(has_other, comm))
      throw InputError(place + ": '" + surface + "' is a line or a point; name a surface");
    area = dealii::Utilities::MPI::sum(area, comm);
    if (!(area > 0.))
      throw InputError(place + ": '" + surface +
                       "' lies on the axis of the body and has no area; name another surface, or "
                       "observe a displacement instead");
    position = dealii::Utilities::MPI::sum(moment, comm) / area;
    for (auto& weight : weights)
      weight.second /= area;
  }

  static std::optional<unsigned int> face_of(const std::uint8_t vertices)
  {
    for (unsigned int f = 0; f < dealii::GeometryInfo<dim>::faces_per_cell; ++f)
      if (face_vertices<dim>(f) == vertices)
        return f;
    return {};
  }

  double displacement(const BlockVector& x) const
  {
    double sum = 0.;
    for (const auto& [dof, weight] : weights)
      sum += weight * x(dof);
    return dealii::Utilities::MPI::sum(sum, comm);
  }

  MPI_Comm comm = MPI_COMM_SELF;
  double position = 0.; ///< mm, in the undeformed body
  std::vector<std::pair<dealii::types::global_dof_index, double>> weights;
};

/// Mean stretch lambda_i of the body between two surfaces that face each other along X_i.
template <int dim>
class Stretch final : public Observable<dim>
{
public:
  Stretch(const ObservableName& name, const unsigned int direction)
      : Observable<dim>(name), direction(direction)
  {
  }

  void declare(dealii::ParameterHandler& prm) override
  {
    prm.add_parameter("From", from, "Surface at the low end.");
    prm.add_parameter("To", to, "Surface at the high end.");
  }

  void setup(const ObservableInput<dim>& scene) override
  {
    low.setup(scene, from, this->name.place("From"), direction);
    high.setup(scene, to, this->name.place("To"), direction);
    if (!(high.position > low.position))
      throw InputError(this->name.place("To") + ": '" + to + "' does not lie above '" + from +
                       "'; name surfaces with material between them");
  }

  std::vector<std::string> columns_of_kind() const override
  {
    return {"lambda_" + std::to_string(axis<dim>(direction) + 1)};
  }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    const double change = high.displacement(scene.state.x) - low.displacement(scene.state.x);
    return {1. + change / (high.position - low.position)};
  }

private:
  unsigned int direction;
  std::string from, to;
  SurfaceMean<dim> low, high;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_stretch(const ObservableName& name,
                                              const unsigned int direction)
{
  return std::make_unique<Stretch<dim>>(name, direction);
}

template std::unique_ptr<Observable<2>> make_stretch(const ObservableName&, unsigned int);
template std::unique_ptr<Observable<3>> make_stretch(const ObservableName&, unsigned int);

} // namespace thelma
