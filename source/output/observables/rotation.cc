#include <thelma/base/error.h>
#include <thelma/base/quantity.h>
#include <thelma/output/observables/observables.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace thelma
{
namespace
{

/// Rotation about x2 of the section X3 = const: the angle of the rigid motion closest to that of
/// its nodes (least squares). Past full turns it is followed along the body, from section to
/// section, so that it depends on the state alone. In degrees, positive from x3 towards x1.
template <int dim>
class Rotation final : public Observable<dim>
{
public:
  using Observable<dim>::Observable;

  void declare(dealii::ParameterHandler& prm) override
  {
    add_quantity(prm, "Section", position, "X3 of the section; nodes must lie on it.",
                 Quantity("mm"));
  }

  void setup(const ObservableInput<dim>& scene) override
  {
    if (scene.layout.is_axisymmetric())
      throw InputError(this->name.place("Section") +
                       ": the sections X3 = const of an axisymmetric "
                       "body become cones and have no rotation; observe displacements, or remove "
                       "it from Output/Observables");
    const dealii::Mapping<dim>& mapping = scene.layout.mapping();
    const auto& points = scene.layout.scalar_element().get_unit_support_points();
    const auto owned = scene.layout.dof_handler().locally_owned_dofs();
    double tolerance = std::numeric_limits<double>::max();
    for (const Cell<dim>& cell : scene.layout.cells()) {
      tolerance = std::min(tolerance, 1e-6 * cell.iterator->diameter());
      for (unsigned int a = 0; a < points.size(); ++a) {
        const auto X = mapping.transform_unit_to_real_cell(cell.iterator, points[a]);
        const auto* dofs = cell.dofs.data() + a * cell.n_components;
        if (X[dim - 1] < position + tolerance && owned.is_element(dofs[0]))
          nodes[dofs[0]] = {X[0], X[dim - 1], dofs[dim - 1], 0};
      }
    }
    tolerance = dealii::Utilities::MPI::min(tolerance, scene.layout.communicator());
    number_sections(scene.layout.communicator(), tolerance);
  }

  std::vector<std::string> columns_of_kind() const override { return {this->name.kind + "_deg"}; }

  std::vector<double> evaluate(const ObservableInput<dim>& scene) override
  {
    // Sums over the nodes of each section of 1, X1, x1, x3, X1 x1, X1 x3, X1^2.
    constexpr int n_sums = 7;
    std::vector<double> own(n_sums * n_sections, 0.), sums(own.size());
    for (const auto& [dof, node] : nodes) {
      const double X1 = node.X1, x1 = X1 + scene.state.x(dof), x3 = scene.state.x(node.u3);
      const double terms[n_sums] = {1., X1, x1, x3, X1 * x1, X1 * x3, X1 * X1};
      for (int i = 0; i < n_sums; ++i)
        own[n_sums * node.section + i] += terms[i];
    }
    dealii::Utilities::MPI::sum(own, scene.layout.communicator(), sums);
    double angle = 0.;
    for (std::size_t k = 0; k < n_sections; ++k) {
      const double* s = sums.data() + n_sums * k;
      if (!(s[6] * s[0] > s[1] * s[1] * (1. + 1e-12)))
        continue; // a single node, or a line along x2, has no angle
      const double along_x1 = s[4] - s[1] * s[2] / s[0], along_x3 = s[5] - s[1] * s[3] / s[0];
      const double found = std::atan2(-along_x3, along_x1) * 180. / dealii::numbers::PI;
      angle += std::remainder(found - angle, 360.);
    }
    return {angle};
  }

private:
  struct Node {
    double X1, X3; ///< mm
    dealii::types::global_dof_index u3;
    std::size_t section;
  };

  /// Sort the nodes of all ranks into sections of equal X3.
  void number_sections(const MPI_Comm comm, const double tolerance)
  {
    std::vector<double> heights;
    for (const auto& entry : nodes)
      heights.push_back(entry.second.X3);
    const auto all = dealii::Utilities::MPI::all_gather(comm, heights);
    heights.clear();
    for (const auto& part : all)
      heights.insert(heights.end(), part.begin(), part.end());
    std::sort(heights.begin(), heights.end());
    const std::size_t count =
        heights.end() - std::lower_bound(heights.begin(), heights.end(), position - tolerance);
    if (count < 2)
      throw InputError(this->name.place("Section") + ": no nodes at X3 = " + as_text(position) +
                       " mm; choose a section that the mesh has");
    const auto same = [&](const double a, const double b) { return b - a < tolerance; };
    heights.erase(std::unique(heights.begin(), heights.end(), same), heights.end());
    n_sections = heights.size();
    for (auto& entry : nodes)
      entry.second.section =
          std::lower_bound(heights.begin(), heights.end(), entry.second.X3 - tolerance) -
          heights.begin();
  }

  double position = 0.;
  std::size_t n_sections = 0;
  std::map<dealii::types::global_dof_index, Node> nodes; ///< by their u1 unknown
};

} // namespace

template <int dim>
std::unique_ptr<Observable<dim>> make_rotation(const ObservableName& name)
{
  return std::make_unique<Rotation<dim>>(name);
}

template std::unique_ptr<Observable<2>> make_rotation(const ObservableName&);
template std::unique_ptr<Observable<3>> make_rotation(const ObservableName&);

} // namespace thelma
