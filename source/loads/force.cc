#include <thelma/base/input_errors.h>
#include <thelma/base/parameters.h>
#include <thelma/base/quantity.h>
#include <thelma/fields/outer_faces.h>
#include <thelma/loads/load_list.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <map>
#include <regex>
#include <sstream>

namespace thelma
{
namespace
{

/// Components with a unit behind the last one, if it is not @p unit.
template <int dim>
dealii::Tensor<1, dim> parse_force(const std::string& text, const std::string& unit)
{
  std::istringstream words(text);
  std::vector<std::string> numbers(dim);
  for (std::string& number : numbers)
    words >> number;
  std::string rest;
  std::getline(words, rest);
  const std::string problem = "'" + text + "' is no force; write its " + std::to_string(dim) +
                              " components in " + unit + " with blanks between";
  if (numbers.back().empty())
    throw InputError(problem);
  if (dim == 2 && std::regex_search(rest, std::regex("^ *[-+.0-9]")))
    throw InputError("'" + text +
                     "' has three components, but the plane of x1 and x3 only two; "
                     "leave out the one along x2");
  dealii::Tensor<1, dim> force;
  try {
    for (unsigned int d = 0; d < dim; ++d)
      force[d] = Quantity(unit).value(numbers[d] + rest);
  } catch (const InputError& error) {
    throw InputError(problem + ": " + error.what());
  }
  if (force.norm() == 0.)
    throw InputError("'" + text + "' is a force of 0; write another, or remove it");
  return force;
}

/// Forces on surfaces that keep size and direction while the body deforms, spread evenly over the
/// undeformed surface.
template <int dim>
class Force final : public Load<dim>
{
public:
  void declare(dealii::ParameterHandler& prm) override
  {
    using namespace dealii::Patterns;
    const Section section(prm, {"Loads"});
    prm.add_parameter(
        "Force", texts,
        "Forces on surfaces, to which the stage `force` (Loading/Stages) goes, as "
        "`grip: 0 0 0.05`. They keep their direction and are spread evenly over the "
        "undeformed surface. Unit: N, in plane strain N/mm of depth; in an axisymmetric "
        "scene on the whole ring, along x1 the sum of the radial forces.",
        Map(Anything(), Anything(), 0, 100));
    check_values(prm, "Force", [](const std::string& force) {
      try {
        parse_force<dim>(force, "N");
      } catch (const InputError&) {
        if (dim == 3)
          throw;
        parse_force<dim>(force, "N/mm"); // whether it is plane strain is known with the mesh
      }
    });
  }

  void setup(const LoadInput<dim>& input) override
  {
    if (!is_present())
      return;
    forces = input.layout.new_vector();
    const std::string unit = input.layout.n_sizes() == 3 ? "N" : "N/mm";
    InputErrors errors;
    for (const auto& [surface, text] : texts)
      errors.collect([&, &surface = surface, &text = text]() {
        add(input.mesh, input.layout, surface, force(text, unit));
      });
    errors.raise();
  }

  bool is_present() const override { return !texts.empty(); }
  SceneEntry entry() const override { return {"Loads", "Force"}; }
  Field acts_on() const override { return Field::displacement; }
  bool is_dead() const override { return true; }
  AmplitudeEntry amplitude() const override { return {"Force", "Multiple of the forces"}; }
  LevelText text() const override { return {"", " times the force"}; }

  void add_forces(const double factor, const Instant& at, const State& /*state*/,
                  const BlockVector& /*x*/, BlockVector& nodal) const override
  {
    nodal.add(factor * at.level, forces);
  }

private:
  dealii::Tensor<1, dim> force(const std::string& text, const std::string& unit) const
  {
    try {
      return parse_force<dim>(text, unit);
    } catch (const InputError& error) {
      throw InputError(entry().place() + ": " + error.what());
    }
  }

  void add(const Mesh<dim>& mesh, const DofLayout<dim>& layout, const std::string& surface,
           const dealii::Tensor<1, dim>& force)
  {
    BlockVector shares = layout.new_vector();
    double area = 0.;
    const bool outer = for_each_outer_face(
        mesh, layout, surface, entry().place(), dealii::QGauss<dim - 1>(layout.degree() + 1),
        [&](const OuterFace<dim>& face) {
          for (unsigned int q = 0; q < face.values.n_quadrature_points; ++q) {
            area += face.area(q);
            for (unsigned int a = 0; a < face.values.dofs_per_cell; ++a)
              for (unsigned int d = 0; d < dim; ++d)
                shares(face.unknown(a, d)) +=
                    force[d] * face.area(q) * face.values.shape_value(a, q);
          }
        });
    area = dealii::Utilities::MPI::sum(area, layout.communicator());
    if (!outer)
      throw InputError(entry().place() + ": '" + surface +
                       "' is no outer surface of the body; forces can act only on these");
    shares.compress(dealii::VectorOperation::add);
    forces.add(1. / area, shares);
  }

  std::map<std::string, std::string> texts;
  BlockVector forces; ///< N, in plane strain N per mm of depth
};

} // namespace

template <int dim>
std::unique_ptr<Load<dim>> make_force()
{
  return std::make_unique<Force<dim>>();
}

template std::unique_ptr<Load<2>> make_force();
template std::unique_ptr<Load<3>> make_force();

} // namespace thelma
