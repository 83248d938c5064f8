#include <thelma/elements/pressure_dilatation.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_dgq.h>

namespace thelma
{
namespace
{

/// The volumetric energy at the Gauss rule of one point less per direction, the rest at the full
/// one (theory.md, eq. 25): the paper's cure for volumetric locking. Each reduced point has a
/// pressure and a dilatation of its own. In balance the dilatation is J there, so the states are
/// those of the displacements alone, but Newton's method finds them in fewer iterations.
template <int dim>
class SelectiveReduced final : public PressureDilatation<dim>
{
public:
  void setup(const DofLayout<dim>& layout) override
  {
    const unsigned int n_points = layout.degree(), n_modes = dealii::QGauss<dim>(n_points).size();
    std::vector<Modes> modes(n_modes, Modes{});
    for (unsigned int q = 0; q < n_modes; ++q)
      modes[q][q] = 1.;
    this->use(layout, n_points, modes, n_modes);
    between_points.emplace(dealii::QGauss<1>(n_points));
  }

protected:
  Modes modes_at(const dealii::Point<dim>& xi) const override
  {
    Modes values{};
    for (unsigned int i = 0; i < between_points->dofs_per_cell; ++i)
      values[i] = between_points->shape_value(i, xi);
    return values;
  }

private:
  std::optional<dealii::FE_DGQArbitraryNodes<dim>> between_points;
};

} // namespace

template <int dim>
std::unique_ptr<Formulation<dim>> make_selective_reduced()
{
  return std::make_unique<SelectiveReduced<dim>>();
}

template std::unique_ptr<Formulation<2>> make_selective_reduced();
template std::unique_ptr<Formulation<3>> make_selective_reduced();

} // namespace thelma
