#include <thelma/base/axes.h>
#include <thelma/base/error.h>
#include <thelma/output/observables.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q1.h>

#include <array>
#include <cmath>
#include <map>

namespace thelma
{
namespace
{

/// Rotation about x2 of the section X3 = const: the angle of the rigid motion closest to that of
/// its nodes (least squares), followed past full turns. In degrees, positive from x3 towards x1.
template <int dim>
class Rotation final : public Observable<dim>
{
public:
  explicit Rotation(std::string name) : name(std::move(name)) {}

  void declare(dealii::ParameterHandler& prm) override
  {
    prm.add_parameter("Section", position, "X3 of the section in mm; nodes must lie on it.");
  }

  void setup(const Scene<dim>& scene) override
  {
    const dealii::MappingQ1<dim> mapping;
    const auto& points = scene.layout.scalar_element().get_unit_support_points();
    const auto owned = scene.layout.dof_handler().locally_owned_dofs();
    for (const Cell<dim>& cell : scene.layout.cells())
      for (unsigned int a = 0; a < points.size(); ++a) {
        const auto X = mapping.transform_unit_to_real_cell(cell.iterator, points[a]);
        const auto* dofs = cell.dofs.data() + a * cell.n_components;
        if (std::abs(X[dim - 1] - position) < 1e-6 * cell.iterator->diameter() &&
            owned.is_element(dofs[0]))
          nodes[dofs[0]] = {X[0], dofs[dim - 1]};
      }
    const auto count = dealii::Utilities::MPI::sum(nodes.size(), scene.layout.communicator());
    if (count < 2)
      throw InputError("section Observables/" + name + ", entry 'Section': no nodes at X3 = " +
                       std::to_string(position) + " mm; choose a section that the mesh has");
  }

  std::vector<std::string> columns() const override { return {name + "_deg"}; }

  std::vector<double> evaluate(const Scene<dim>& scene) override
  {
    // Sums over the nodes of 1, X1, x1, x3, X1 x1, X1 x3.
    std::vector<double> sums(6, 0.), s(6);
    for (const auto& [dof, node] : nodes) {
      const double X1 = node.first, x1 = X1 + scene.state.x(dof), x3 = scene.state.x(node.second);
      const double terms[] = {1., X1, x1, x3, X1 * x1, X1 * x3};
      for (int i = 0; i < 6; ++i)
        sums[i] += terms[i];
    }
    dealii::Utilities::MPI::sum(sums, scene.layout.communicator(), s);
    const double along_x1 = s[4] - s[1] * s[2] / s[0], along_x3 = s[5] - s[1] * s[3] / s[0];
    const double angle = std::atan2(-along_x3, along_x1) * 180. / dealii::numbers::PI;
    last += std::remainder(angle - last, 360.);
    return {last};
  }

private:
  std::string name;
  double position = 0.;
  double last = 0.; ///< degrees at the previous step
  /// u1 unknown: X1 in mm and u3 unknown.
  std::map<dealii::types::global_dof_index, std::pair<double, dealii::types::global_dof_index>>
      nodes;
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_rotation(const std::string& name)
{
  return std::make_unique<Rotation<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_rotation(const std::string&);
template std::unique_ptr<Observable<3>> make_rotation(const std::string&);

} // namespace thelma
